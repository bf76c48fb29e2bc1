# web.cmake -- targets for WebAssembly besides the libraries: the engine of the npm package, and the program whose hashes tests
# compare.

# the JavaScript optimizers that Emscripten runs at link time need acorn; node finds it with the path of Debian's modules
set_property(GLOBAL PROPERTY RULE_LAUNCH_LINK "${CMAKE_COMMAND} -E env NODE_PATH=/usr/share/nodejs")

# the package: scree.js and its types, made from the header; the engine has no JavaScript of Emscripten, so no threads
if(NOT CMAKE_C_FLAGS MATCHES "-pthread")
	find_program(SCREE_NODE NAMES node nodejs REQUIRED)
	set(package ${PROJECT_BINARY_DIR}/package)
	set(tools ${PROJECT_SOURCE_DIR}/web/package)
	file(MAKE_DIRECTORY ${package})
	add_custom_command(OUTPUT ${package}/scree.js ${package}/scree.d.ts ${package}/exports.json ${package}/layout.c
		COMMAND ${SCREE_NODE} ${tools}/generate.mjs ${PROJECT_SOURCE_DIR}/include/scree/scree.h ${tools}/runtime.js ${package}
		DEPENDS ${PROJECT_SOURCE_DIR}/include/scree/scree.h ${tools}/generate.mjs ${tools}/header.mjs ${tools}/types.mjs
			${tools}/runtime.js
		COMMENT "Making the package from scree.h" VERBATIM)
	# layout.c asserts that the offsets of members in the compiler are those in the package
	add_executable(engine ${tools}/auto.c ${tools}/libc.c ${package}/layout.c)
	scree_flags(engine)
	set_target_properties(engine PROPERTIES SUFFIX .wasm LINK_DEPENDS ${package}/exports.json)
	target_link_libraries(engine PRIVATE scree_internals)
	# saves 1 kB; no code of the engine relies on a trap
	find_program(SCREE_WASM_OPT wasm-opt REQUIRED)
	set(features --mvp-features)
	if(CMAKE_C_FLAGS MATCHES "-msimd128")
		list(APPEND features --enable-simd --enable-bulk-memory --enable-sign-ext --enable-nontrapping-float-to-int)
	endif()
	# strips before -Oz; after it the package would be 0.3 kB larger
	add_custom_command(TARGET engine POST_BUILD COMMAND ${SCREE_WASM_OPT} ${features} --strip-producers --strip-target-features
		-Oz --traps-never-happen --low-memory-unused --converge $<TARGET_FILE:engine> -o $<TARGET_FILE:engine>)
	target_link_options(engine PRIVATE -O2 --no-entry -sALLOW_MEMORY_GROWTH -sMALLOC=emmalloc -sERROR_ON_UNDEFINED_SYMBOLS=0
		-sWARN_ON_UNDEFINED_SYMBOLS=0 -sEXPORTED_FUNCTIONS=@${package}/exports.json)
endif()

if(TARGET scree_scene)
	add_executable(golden tests/web/golden.c)
	scree_flags(golden)
	target_link_libraries(golden PRIVATE scree_scene scree_internals)
	# real files; main runs in a thread of its own, so that it can wait for others
	target_link_options(golden PRIVATE -O1 -sALLOW_MEMORY_GROWTH -sNODERAWFS -sEXIT_RUNTIME)
	if(CMAKE_C_FLAGS MATCHES "-pthread")
		target_link_options(golden PRIVATE -sPROXY_TO_PTHREAD -Wno-pthreads-mem-growth)
	endif()
endif()
