# emscripten.cmake -- loads the toolchain of WebAssembly from the Emscripten on the path, as Debian installs it.
find_program(SCREE_EM_CONFIG em-config DOC "Emscripten's em-config")
if(NOT SCREE_EM_CONFIG)
	message(FATAL_ERROR "scree: WebAssembly needs Emscripten, which was not found; Debian has it in emscripten")
endif()
execute_process(COMMAND ${SCREE_EM_CONFIG} EMSCRIPTEN_ROOT OUTPUT_VARIABLE root OUTPUT_STRIP_TRAILING_WHITESPACE)
include(${root}/cmake/Modules/Platform/Emscripten.cmake)
