# The font of plots becomes a part of the program, so that a picture looks the same wherever it is made.
find_file(TEXBRDF_FONT DejaVuSans.ttf REQUIRED
  PATHS /usr/share/fonts/truetype/dejavu /usr/share/fonts/dejavu-sans-fonts /usr/share/fonts/TTF /usr/share/fonts/dejavu)
set(font_source ${PROJECT_BINARY_DIR}/plots/font_file.cpp)
set(font_script ${PROJECT_SOURCE_DIR}/cmake/EmbedBytes.cmake)
add_custom_command(OUTPUT ${font_source}
  COMMAND ${CMAKE_COMMAND} -DIN=${TEXBRDF_FONT} -DOUT=${font_source} -DNAMESPACE=texbrdf::plots -DNAME=font_file
    -P ${font_script}
  DEPENDS ${TEXBRDF_FONT} ${font_script}
  VERBATIM)
target_sources(texbrdf_plots PRIVATE ${font_source})
