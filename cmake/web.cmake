# web.cmake -- builds targets for WebAssembly besides the libraries: the engine of the npm package, and golden,
# which prints the hashes of scenes for tests.

# the JavaScript optimizers that Emscripten runs at link time need acorn; NODE_PATH is the folder of Debian's node
# modules
set_property(GLOBAL PROPERTY RULE_LAUNCH_LINK "${CMAKE_COMMAND} -E env NODE_PATH=/usr/share/nodejs")

# makes the package: scree.js and its types are generated from the header; the engine has no JavaScript of Emscripten, so it has no
# threads
if(NOT CMAKE_C_FLAGS MATCHES "-pthread")
	find_program(SCREE_NODE NAMES node nodejs REQUIRED)
	set(package ${PROJECT_BINARY_DIR}/package)
	set(tools ${PROJECT_SOURCE_DIR}/web/package)
	file(MAKE_DIRECTORY ${package})
	add_custom_command(OUTPUT ${package}/scree.js ${package}/scree.d.ts ${package}/draw.js ${package}/draw.d.ts ${package}/batch.js ${package}/batch.d.ts
			${package}/exports.json ${package}/batch_exports.json ${package}/layout.c
		COMMAND ${SCREE_NODE} ${tools}/generate.mjs ${PROJECT_SOURCE_DIR}/include/scree/scree.h ${package}
		DEPENDS ${PROJECT_SOURCE_DIR}/include/scree/scree.h ${tools}/generate.mjs ${tools}/header.mjs ${tools}/types.mjs
			${tools}/engine.js ${tools}/objects.js ${tools}/clock.js ${tools}/runtime.js
			${tools}/draw.js ${tools}/draw.d.ts ${tools}/batch.js ${tools}/batch.d.ts
		COMMENT "Making the package from scree.h" VERBATIM)
	# the library without batches, for the engine of "scree"; that of "scree/batch" has them, as the page has
	add_library(scree_small STATIC EXCLUDE_FROM_ALL ${small_sources})
	scree_flags(scree_small)
	target_compile_definitions(scree_small PRIVATE SCREE_BUILDING SCREE_LANES=${lanes} SCREE_NO_OPENCL SCREE_SMALL SCREE_NO_BATCHES)
	target_link_options(scree_small PUBLIC ${SCREE_LINK_FLAGS})
	# wasm-opt saves 1 kB; --traps-never-happen is safe, because no code of the engine relies on a trap
	find_program(SCREE_WASM_OPT wasm-opt REQUIRED)
	set(features --mvp-features)
	if(CMAKE_C_FLAGS MATCHES "-msimd128")
		list(APPEND features --enable-simd --enable-bulk-memory --enable-sign-ext --enable-nontrapping-float-to-int)
	endif()
	foreach(target engine batch_engine)
		set(library scree_small)
		set(exports ${package}/exports.json)
		if(target STREQUAL "batch_engine")
			set(library scree_internals)
			set(exports ${package}/batch_exports.json)
		endif()
		# layout.c asserts that each member has the same offset in C and in the package
		add_executable(${target} ${tools}/auto.c ${tools}/libc.c ${package}/layout.c)
		scree_flags(${target})
		target_link_libraries(${target} PRIVATE ${library})
		set_target_properties(${target} PROPERTIES SUFFIX .wasm LINK_DEPENDS ${exports})
		# strips before -Oz; stripping after -Oz would make the package 0.3 kB larger
		add_custom_command(TARGET ${target} POST_BUILD COMMAND ${SCREE_WASM_OPT} ${features} --strip-producers --strip-target-features
			-Oz --traps-never-happen --low-memory-unused --converge $<TARGET_FILE:${target}> -o $<TARGET_FILE:${target}>)
		target_link_options(${target} PRIVATE -O2 --no-entry -sALLOW_MEMORY_GROWTH -sALLOW_TABLE_GROWTH -sMALLOC=emmalloc
			-sERROR_ON_UNDEFINED_SYMBOLS=0 -sWARN_ON_UNDEFINED_SYMBOLS=0 -sEXPORTED_FUNCTIONS=@${exports})
	endforeach()

	# debug draw: position-independent code that a program adds to either engine, in its memory; without vectors, for both engines
	if(NOT CMAKE_C_FLAGS MATCHES "-msimd128")
		file(GLOB draw_sources ${PROJECT_SOURCE_DIR}/src/api/draw/*.c)
		# these sources have no state; as parts of the module, they take no names that the engine exports
		add_executable(draw ${tools}/draw.c ${draw_sources} src/world/check.c src/world/definition.c)
		scree_flags(draw)
		set_target_properties(draw PROPERTIES SUFFIX .wasm)
		target_include_directories(draw PRIVATE ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR}/src ${PROJECT_BINARY_DIR})
		target_compile_definitions(draw PRIVATE SCREE_BUILDING SCREE_LANES=1 SCREE_NO_OPENCL SCREE_SMALL)
		target_compile_options(draw PRIVATE -fPIC -fno-lto)
		target_link_options(draw PRIVATE -fno-lto -O2 -sSIDE_MODULE=2 -sEXPORTED_FUNCTIONS=_draw_def,_draw_world -sERROR_ON_UNDEFINED_SYMBOLS=0
			-sWARN_ON_UNDEFINED_SYMBOLS=0)
		add_custom_command(TARGET draw POST_BUILD COMMAND ${SCREE_WASM_OPT} --mvp-features --enable-mutable-globals --strip-producers
			--strip-target-features -Oz $<TARGET_FILE:draw> -o $<TARGET_FILE:draw>)
	endif()
endif()

if(TARGET scree_scene_internals)
	set_target_properties(golden PROPERTIES EXCLUDE_FROM_ALL OFF)
	# NODERAWFS gives access to real files; with threads, main runs in a separate thread, which may wait for other
	# threads
	target_link_options(golden PRIVATE -O1 -sALLOW_MEMORY_GROWTH -sNODERAWFS -sEXIT_RUNTIME)
	if(CMAKE_C_FLAGS MATCHES "-pthread")
		target_link_options(golden PRIVATE -sPROXY_TO_PTHREAD -Wno-pthreads-mem-growth)
	endif()
endif()
