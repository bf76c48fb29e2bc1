# texts.cmake -- writes text files as arrays of chars into one C file: view/glsl/body.vert becomes glsl_body_vert.
#
# Run at build time: cmake "-DFILES=view/glsl/body.vert view/glsl/body.frag" -DOUT=glsl.c -P texts.cmake
string(REPLACE " " ";" FILES "${FILES}")
set(result "#include \"view/glsl.h\"\n")
foreach(file IN LISTS FILES)
	get_filename_component(name ${file} NAME)
	string(MAKE_C_IDENTIFIER "glsl_${name}" name)
	file(READ "${file}" hex HEX)
	string(REGEX REPLACE "(................................)" "\\1\n" hex "${hex}")
	string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," hex "${hex}")
	string(APPEND result "const char ${name}[] = {\n${hex}0};\n")
endforeach()
file(WRITE "${OUT}" "${result}")
