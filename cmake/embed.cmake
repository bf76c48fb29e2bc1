# embed.cmake -- writes the OpenCL program as one array of chars: the file ENTRY, with each include replaced by the
# text of the included file.
#
# Run at build time: cmake -DROOT=. -DENTRY=opencl/kernels.cl -DNAME=opencl_program -DOUT=program.c -P embed.cmake
#
# Includes are searched in src, then in ROOT. A header is inlined at its first include, a .def (a list of X lines) at
# each of its includes. Each piece begins with a #line with file name and line, so that compiler messages name the
# source. Comments are left out, and so are the headers that only the CPU uses (platform/exact_floats.h,
# dialect/extremes.h, dialect/box_overlaps.h, dialect/transpose.h). Text is always quoted and searched with FIND: if it were a list, CMake
# would split it at semicolons and join elements at brackets.

function(inline path out)
	set(file "${ROOT}/src/${path}")
	if(NOT EXISTS "${file}")
		set(file "${ROOT}/${path}")
	endif()
	file(READ "${file}" text)
	string(REGEX REPLACE "[ \t]*//[^\n]*" "" text "${text}")
	set(result "#line 1 \"${path}\"\n")
	set(line 1)
	string(FIND "${text}" "#include \"" at)
	while(NOT at EQUAL -1)
		string(SUBSTRING "${text}" 0 ${at} before)
		string(SUBSTRING "${text}" ${at} -1 text)
		string(REGEX MATCH "^#include \"([^\"\n]*)\"" directive "${text}")
		set(name "${CMAKE_MATCH_1}")
		string(LENGTH "${directive}" length)
		string(SUBSTRING "${text}" ${length} -1 text)
		string(REGEX REPLACE "[^\n]" "" newlines "${before}")
		string(LENGTH "${newlines}" passed)
		math(EXPR line "${line} + ${passed}")

		string(APPEND result "${before}")
		get_property(seen GLOBAL PROPERTY inlined_${name})
		if(NOT seen AND NOT name MATCHES "^(platform/exact_floats|dialect/(extremes|box_overlaps|transpose)).h$")
			if(NOT name MATCHES "\\.def$")
				set_property(GLOBAL PROPERTY inlined_${name} TRUE)
			endif()
			inline("${name}" inner)
			string(APPEND result "${inner}\n#line ${line} \"${path}\"\n")
		endif()
		string(FIND "${text}" "#include \"" at)
	endwhile()
	set(${out} "${result}${text}" PARENT_SCOPE)
endfunction()

# Makes the arguments of every kernel: the buffers, and for each kind of items its capacity and its offset in the
# buffer, in units of 256 bytes. One buffer holds the pools of one kind or of several kinds, one behind the other (src/pools/buffers.def). One
# argument for each pool would cost 15 us per launch (75 buffers, NVIDIA).
file(READ "${ROOT}/src/pools/buffers.def" sharing)
string(REGEX REPLACE "//[^\n]*" "" sharing "${sharing}")
string(REGEX MATCHALL "SHARES\\([A-Z_]+, [A-Z_]+\\)" sharing "${sharing}")
foreach(share IN LISTS sharing)
	string(REGEX MATCH "([A-Z_]+), ([A-Z_]+)" _ "${share}")
	set(home_of_${CMAKE_MATCH_1} of_${CMAKE_MATCH_2})
endforeach()
include("${ROOT}/cmake/pools.cmake")
scree_pools(pools "${ROOT}")
foreach(pool IN LISTS pools)
	string(REGEX MATCH "([^ ]+) ([^ ]+) ([^ ]+)" _ "${pool}")
	set(type ${CMAKE_MATCH_1})
	set(kind of_${CMAKE_MATCH_3})
	if(NOT DEFINED before_${kind})
		string(APPEND capacities "int ${kind}; ")
		set(before_${kind} "0")
		if(DEFINED home_${kind})
			set(place_${kind} "${home_${kind}} + ((ulong)capacities.begin_${kind} << 8)")
			string(APPEND begins "uint begin_${kind}; ")
		else()
			set(place_${kind} "${kind}")
			string(APPEND arguments "__global uchar* ${kind}, ")
		endif()
	endif()
	string(APPEND names "(__global ${type}*)(${place_${kind}} + (ulong)capacities.${kind} * (${before_${kind}})), ")
	string(APPEND before_${kind} " + sizeof(${type})")
endforeach()
string(APPEND arguments "Capacities capacities, ")

inline("${ENTRY}" program)
set(program "typedef struct { ${begins}${capacities}} Capacities;
#define POOL_ARGUMENTS ${arguments}
#define POOL_NAMES ${names}
${program}")
string(LENGTH "${program}" length)
string(HEX "${program}" hex)
string(REGEX REPLACE "(................................)" "\\1\n" hex "${hex}")
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," hex "${hex}")
file(WRITE "${OUT}" "#include <stddef.h>
extern const char ${NAME}[];
extern const size_t ${NAME}_length;
const char ${NAME}[] = {
${hex}0};
const size_t ${NAME}_length = ${length};
")
