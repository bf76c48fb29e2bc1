# web.cmake -- what is made for WebAssembly besides the libraries: the program whose hashes tests compare, run by node.

# optimizers of JavaScript that Emscripten runs when it links need acorn, which node finds when it is told where Debian has it
set_property(GLOBAL PROPERTY RULE_LAUNCH_LINK "${CMAKE_COMMAND} -E env NODE_PATH=/usr/share/nodejs")

if(TARGET scree_scene)
	add_executable(golden tests/web/golden.c)
	scree_flags(golden)
	target_link_libraries(golden PRIVATE scree_scene scree_static)
	# real files; main in a thread of its own, so that it can wait for others
	target_link_options(golden PRIVATE -sALLOW_MEMORY_GROWTH -sNODERAWFS -sEXIT_RUNTIME)
	if(CMAKE_C_FLAGS MATCHES "-pthread")
		target_link_options(golden PRIVATE -sPROXY_TO_PTHREAD -Wno-pthreads-mem-growth)
	endif()
endif()
