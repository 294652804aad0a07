# The preview's pane for browsers: what esbuild makes of vscode-extension, in a C++ source of the program. Where Node or
# the packages of vscode-extension are missing (`./dev` installs them), the program is built without it and says so.
set(pane_extension ${PROJECT_SOURCE_DIR}/vscode-extension)
set(pane_source ${PROJECT_BINARY_DIR}/pane/embedded_files.cpp)
set(pane_script ${PROJECT_SOURCE_DIR}/cmake/EmbedFiles.cmake)
find_program(TEXBRDF_NODE node)

if(TEXBRDF_NODE AND EXISTS ${pane_extension}/node_modules/esbuild)
  set(pane_folder ${PROJECT_BINARY_DIR}/pane/files)
  file(GLOB_RECURSE pane_sources CONFIGURE_DEPENDS ${pane_extension}/src/*.ts ${pane_extension}/media/*.css)
  add_custom_command(OUTPUT ${pane_source}
    COMMAND ${TEXBRDF_NODE} esbuild.mjs --browser ${pane_folder}
    COMMAND ${CMAKE_COMMAND} -DOUT=${pane_source} -DFOLDER=${pane_folder} -P ${pane_script}
    DEPENDS ${pane_sources} ${pane_extension}/esbuild.mjs ${pane_extension}/package-lock.json ${pane_script}
    WORKING_DIRECTORY ${pane_extension}
    COMMENT "Bundling the preview's pane for browsers"
    VERBATIM)
else()
  message(STATUS "Node or the packages of vscode-extension are missing: no preview for browsers")
  add_custom_command(OUTPUT ${pane_source}
    COMMAND ${CMAKE_COMMAND} -DOUT=${pane_source} -P ${pane_script}
    DEPENDS ${pane_script}
    VERBATIM)
endif()
target_sources(texbrdf_pane PRIVATE ${pane_source})
