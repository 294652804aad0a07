# cmake -DIN=FILE -DOUT=FILE.cpp -DNAMESPACE=a::b -DNAME=function -P EmbedBytes.cmake: the bytes of the file as the C++
# source of a function that gives them as a std::string_view.
file(READ ${IN} bytes HEX)
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "'\\\\x\\1'," bytes "${bytes}")
set(text "// Written by cmake/EmbedBytes.cmake.\n#include <string_view>\n\nnamespace ${NAMESPACE} {\n")
string(APPEND text "namespace {\n\nconstexpr char kBytes[] = {${bytes}};\n\n}  // namespace\n\n")
string(APPEND text "std::string_view ${NAME}();\n\nstd::string_view ${NAME}() {\n  return {kBytes, sizeof kBytes};\n}\n\n")
string(APPEND text "}  // namespace ${NAMESPACE}\n")
file(WRITE ${OUT} "${text}")
