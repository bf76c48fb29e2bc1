# flags.cmake -- scree_flags(target): how every file of this project is compiled.

# What the promise of equal bits needs: a * b + c is two roundings everywhere. What costs nothing: no stage reads errno
# or floating-point exceptions, so the compiler may treat sqrt and divisions as pure. Nothing else of fast-math is safe.
set(SCREE_FLOAT_FLAGS -ffp-contract=off -fno-math-errno -fno-trapping-math)

set(SCREE_LINK_FLAGS "")
if(SCREE_SANITIZE)
	set(SCREE_LINK_FLAGS -fsanitize=${SCREE_SANITIZE})
endif()

function(scree_flags target)
	set(anywhere ON)
	if(EMSCRIPTEN)
		set(anywhere OFF) # WebAssembly is linked into one module
	endif()
	set_target_properties(${target} PROPERTIES C_STANDARD 17 C_STANDARD_REQUIRED ON C_EXTENSIONS OFF
		POSITION_INDEPENDENT_CODE ${anywhere} C_VISIBILITY_PRESET hidden)
	target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR}/src
		${PROJECT_SOURCE_DIR})
	target_compile_options(${target} PRIVATE ${SCREE_FLOAT_FLAGS} -Wall -Wextra -Wshadow
		$<$<COMPILE_LANGUAGE:C>:-Wstrict-prototypes>)
	# assertions name files by their path in the sources, so that no byte depends on the folder of the build
	target_compile_options(${target} PRIVATE -fmacro-prefix-map=${PROJECT_SOURCE_DIR}/=)
	# vectors are passed only between functions of one file
	target_compile_options(${target} PRIVATE -Wno-psabi)
	if(NOT WIN32 AND NOT EMSCRIPTEN)
		target_compile_options(${target} PRIVATE -fno-semantic-interposition)
	endif()
	if(CMAKE_SYSTEM_NAME MATCHES "^(Linux|Emscripten)$")
		# empty, so that a file may still say it itself; C17 alone hides popen, clock_gettime and the like; C++ says it
		target_compile_definitions(${target} PRIVATE $<$<COMPILE_LANGUAGE:C>:_GNU_SOURCE=>)
	endif()
	if(SCREE_WERROR)
		target_compile_options(${target} PRIVATE -Werror)
	endif()
	if(SCREE_SANITIZE)
		target_compile_options(${target} PRIVATE -fsanitize=${SCREE_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer -g1)
		target_link_options(${target} PRIVATE -fsanitize=${SCREE_SANITIZE})
	endif()
endfunction()

# One file a width, each for the instructions that its width needs; chosen at run time by what the processor has. What is
# not wide goes with eight lanes or more from scalar_avx2.c.
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64)$")
	set_source_files_properties(src/cpu/lanes8.c src/cpu/scalar_avx2.c PROPERTIES COMPILE_OPTIONS "-mavx2")
	set_source_files_properties(src/cpu/lanes16.c PROPERTIES
		COMPILE_OPTIONS "-mavx512f;-mavx512dq;-mavx512vl;-mavx512bw")
endif()

# A file has all stages. Without this, gcc stops inlining when it has grown by 40 %, and each new stage makes others slower.
if(CMAKE_C_COMPILER_ID STREQUAL "GNU")
	set_property(SOURCE src/cpu/lanes1.c src/cpu/scalar_avx2.c APPEND PROPERTY COMPILE_OPTIONS --param=inline-unit-growth=100)
endif()

# A page downloads all of it: what is not of a step is made small. Loops are unrolled in full or not at all: the two points of a
# contact stay in registers then; in part, loops would be larger and no faster.
if(EMSCRIPTEN)
	set(CMAKE_C_FLAGS_RELEASE "-Oz -DNDEBUG")
	file(GLOB hot src/cpu/*.c)
	# emcc keeps the -fno-inline-functions of -Oz when -O2 follows: without inlining a step takes up to 2.4 times as long
	set(hot_options -O2 -finline-functions -funroll-loops -mllvm -unroll-runtime=0 -mllvm -unroll-allow-partial=0
		-fno-vectorize -fno-slp-vectorize)
	if(CMAKE_C_FLAGS MATCHES "-flto")
		# The linker inlines again, by the same limits. With 45 a step is 1 to 4 % shorter, but the package 0.6 kB larger, compressed, and too
		# large; with 10 a step is 1 to 3 % longer, and the package as large.
		list(APPEND hot_options -mllvm -inline-threshold=24 -mllvm -inlinehint-threshold=24)
		set(SCREE_LINK_FLAGS -Wl,-mllvm,-inline-threshold=24,-mllvm,-inlinehint-threshold=24)
	endif()
	if(NOT 1 IN_LIST SCREE_LANES)
		list(APPEND hot_options -Wno-unused-function) # the wide stages of lanes1.c
	endif()
	set_source_files_properties(${hot} PROPERTIES COMPILE_OPTIONS "${hot_options}")
endif()
