# flags.cmake -- scree_flags(target): sets the compiler flags of every target of this project.

# Equal bits need two roundings in a * b + c everywhere, so contraction is off. No stage reads errno or floating-point
# exceptions, so the compiler may treat sqrt and divisions as pure. No other part of fast-math is safe. Flags of a parent
# project come first, so each is undone by its name: after -ffinite-math-only, -fno-fast-math alone has no effect in gcc.
# In clang, -fno-fast-math turns contraction on, so contraction comes last.
set(SCREE_FLOAT_FLAGS -fno-fast-math -fno-associative-math -fno-reciprocal-math -fno-finite-math-only -fsigned-zeros)
# C and C++ may have different compilers, as with CC=clang and no CXX.
set(gnu "$<OR:$<COMPILE_LANG_AND_ID:C,GNU>,$<COMPILE_LANG_AND_ID:CXX,GNU>>")
# in clang, -fno-unsafe-math-optimizations would turn on floating-point exceptions
foreach(flag -fno-unsafe-math-optimizations -fno-rounding-math -fno-single-precision-constant)
	list(APPEND SCREE_FLOAT_FLAGS $<${gnu}:${flag}>)
endforeach()
if(NOT EMSCRIPTEN)
	list(APPEND SCREE_FLOAT_FLAGS $<$<NOT:${gnu}>:-fdenormal-fp-math=ieee>) # after -Ofast
endif()
list(APPEND SCREE_FLOAT_FLAGS -ffp-contract=off -fno-math-errno -fno-trapping-math)
# No file needs instructions that fuse; lanes16.c turns AVX-512 on again. Floats of 32-bit x86 use SSE2.
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64|i[3-6]86)$" AND NOT EMSCRIPTEN)
	list(APPEND SCREE_FLOAT_FLAGS -mno-avx512f -mno-fma4 -mno-fma -msse2 -mfpmath=sse)
elseif(CMAKE_SYSTEM_PROCESSOR STREQUAL "s390x" AND CMAKE_C_COMPILER_ID STREQUAL "GNU")
	# with -std=c17, gcc for s390x evaluates float expressions in double, although the processor has float instructions
	list(APPEND SCREE_FLOAT_FLAGS -fexcess-precision=fast)
endif()

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
		POSITION_INDEPENDENT_CODE ${anywhere} C_VISIBILITY_PRESET hidden UNITY_BUILD OFF)
	target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR}/src
		${PROJECT_SOURCE_DIR})
	target_compile_options(${target} PRIVATE ${SCREE_FLOAT_FLAGS})
	if(top)
		target_compile_options(${target} PRIVATE -Wall -Wextra -Wshadow $<$<COMPILE_LANGUAGE:C>:-Wstrict-prototypes>)
	else()
		# the warnings of a parent project, and its -Werror and -pedantic-errors, are for its own sources
		target_compile_options(${target} PRIVATE -w -Wno-pedantic)
		set_target_properties(${target} PROPERTIES C_CLANG_TIDY "" C_CPPCHECK "" C_INCLUDE_WHAT_YOU_USE "")
	endif()
	# replaces the folder of the sources in file names of assertions, so that a program does not depend on the folder of
	# the build
	target_compile_options(${target} PRIVATE -fmacro-prefix-map=${PROJECT_SOURCE_DIR}/=)
	# disables warnings about the ABI of vectors, because vectors are passed only between functions of one file
	target_compile_options(${target} PRIVATE -Wno-psabi)
	if(NOT WIN32 AND NOT EMSCRIPTEN)
		target_compile_options(${target} PRIVATE -fno-semantic-interposition)
	endif()
	if(CMAKE_SYSTEM_NAME MATCHES "^(Linux|Emscripten)$")
		# declares popen, clock_gettime and others, which C17 hides. The value is empty, so that a file may define the macro too;
		# C++ compilers always define it.
		target_compile_definitions(${target} PRIVATE $<$<COMPILE_LANGUAGE:C>:_GNU_SOURCE=>)
	endif()
	if(MINGW)
		# selects printf functions of C17, because those of msvcrt.dll lack %zu
		target_compile_definitions(${target} PRIVATE __USE_MINGW_ANSI_STDIO=1)
		if(CMAKE_C_COMPILER_ID STREQUAL "GNU")
			# gcc checks the attribute format(printf) by the rules of msvcrt.dll; all other builds check it by those of C17
			target_compile_options(${target} PRIVATE -Wno-format -Wno-format-extra-args)
		endif()
	endif()
	if(SCREE_WERROR)
		target_compile_options(${target} PRIVATE -Werror)
	endif()
	if(SCREE_SANITIZE)
		target_compile_options(${target} PRIVATE -fsanitize=${SCREE_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer -g1)
		target_link_options(${target} PRIVATE -fsanitize=${SCREE_SANITIZE})
	endif()
endfunction()

# Each number of lanes has a file, compiled for the instructions that it needs. At run time the library selects a number
# of lanes by the features of the processor. With eight lanes or more, kernels of one item come from scalar_avx2.c.
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64)$")
	set_source_files_properties(src/cpu/lanes8.c src/cpu/scalar_avx2.c PROPERTIES COMPILE_OPTIONS "-mavx2")
	set_source_files_properties(src/cpu/lanes16.c PROPERTIES
		COMPILE_OPTIONS "-mavx512f;-mavx512dq;-mavx512vl;-mavx512bw")
	if(WIN32 AND CMAKE_C_COMPILER_ID STREQUAL "GNU")
		# gcc for Windows aligns the stack to 16 bytes only (its bug 54412), so moves of wider vectors must allow any address
		set_property(SOURCE src/cpu/lanes8.c src/cpu/scalar_avx2.c src/cpu/lanes16.c APPEND PROPERTY
			COMPILE_OPTIONS -Wa,-muse-unaligned-vector-move)
	endif()
endif()

# Each of these files holds all stages. Without this option gcc stops inlining when a file has grown by 40 %, so each
# new stage would make other stages slower.
if(CMAKE_C_COMPILER_ID STREQUAL "GNU")
	set_property(SOURCE src/cpu/lanes1.c src/cpu/scalar_avx2.c APPEND PROPERTY COMPILE_OPTIONS --param=inline-unit-growth=100)
endif()

# A page downloads the whole engine, so code outside a step is compiled for size. In code of a step, loops are unrolled
# in full or not at all. Full unrolling keeps the two points of a contact in registers; partly unrolled loops would be
# larger and no faster.
if(EMSCRIPTEN)
	set(CMAKE_C_FLAGS_RELEASE "-Oz -DNDEBUG")
	set(hot src/cpu/lanes1.c src/cpu/lanes4.c src/cpu/primitives.c src/cpu/work.c)
	# -Oz sets -fno-inline-functions in emcc, and a later -O2 does not undo that; without inlining a step takes up to
	# 2.4 times as long
	set(hot_options -O2 -finline-functions -funroll-loops -mllvm -unroll-runtime=0 -mllvm -unroll-allow-partial=0
		-fno-vectorize -fno-slp-vectorize)
	if(CMAKE_C_FLAGS MATCHES "-flto")
		# The linker would inline again, beyond the limits of -Oz: the compressed package would be 0.3 kB larger and no faster.
		set(SCREE_LINK_FLAGS -Wl,-mllvm,-inline-threshold=0,-mllvm,-inlinehint-threshold=0)
		if(CMAKE_C_FLAGS MATCHES "-msimd128")
			# Wide kernels are always inlined, so these thresholds concern other kernels. Compared with 24, a threshold of 45 makes
			# a step 1 to 4 % shorter but the compressed package 0.6 kB larger, which is too large; a threshold of 10 makes a step
			# 1 to 3 % longer and the package no smaller. With one lane, all kernels would be concerned: a step takes up to 36 %
			# longer with 24, and 9 % longer with 150.
			list(APPEND hot_options -mllvm -inline-threshold=24 -mllvm -inlinehint-threshold=24)
		endif()
	endif()
	if(NOT 1 IN_LIST SCREE_LANES)
		list(APPEND hot_options -Wno-unused-function) # the wide stages of lanes1.c
	endif()
	set_source_files_properties(${hot} PROPERTIES COMPILE_OPTIONS "${hot_options}")
endif()
