# one_file.awk -- writes the CPU library as one C file, for one_file.sh: names of files are its arguments, first those of the
# host, then those of src/cpu that compile the stages for a number of lanes.
#
# Every function but those of scree.h becomes static, because a declaration in a header becomes static. Names that several files
# define are changed: static ones of a .c file get the name of the file as a prefix, and macros change those of the stages, which
# the file contains once for each number of lanes.

function resolve(name) { return name == "scree/scree.h" ? name : root "/src/" name }

function read(path, line, n)
{
	if (path in length_of)
		return
	n = 0
	while ((getline line <path) > 0)
	{
		text[path, ++n] = line
		if (sub(/^#[ ]*undef +/, "", line))
			undefined[line] = 1 # by the file that uses it
	}
	close(path)
	if (n == 0)
	{
		print "one_file.awk: " path " is missing or empty" >"/dev/stderr"
		failed = 1
	}
	length_of[path] = n
}

# Returns true for headers whose content depends on the number of lanes.
function is_wide(path) { return path ~ /\/src\/(dialect|stages|constraints)\/.*\.h$/ || path ~ /\/cpu\/(kernel_table|self_test_lanes)\.h$/ }

# Returns true for files that compile the stages for a number of lanes.
function is_unit(path) { return path ~ /\/cpu\/(lanes[0-9]+|scalar_avx2)\.c$/ }

# Returns true for the first line of a struct or an enum that is the same for each number of lanes, because pools have it.
function is_shared(path, line)
{
	return (path in host_has) && (line ~ /^(struct|enum)( [A-Za-z0-9_]+)?$/ || (path ~ /\/dialect\/c_words\.h$/ && line == "typedef struct"))
}

# Returns true for headers that only OpenCL C includes.
function is_opencl(path) { return path ~ /dialect\/(opencl_words|own_rounding)\.h$/ }

# Returns the name that a line of code, without comments, declares outside of functions, and sets `what`.
function declared(line, name)
{
	what = ""
	sub(/[ \t]*\/\/.*/, "", line)
	if (line ~ /^#[ ]*define /)
	{
		what = "macro"
		sub(/^#[ ]*define +/, "", line)
		sub(/[^A-Za-z0-9_].*/, "", line)
		return line
	}
	if (in_enum && line ~ /^\t+[A-Z][A-Z0-9_]*( =|,|$)/)
	{
		what = "object"
		gsub(/^\t+/, "", line)
		gsub(/ = [^,]*/, "", line)
		gsub(/,/, " ", line)
		return line
	}
	if (line ~ /^((typedef|static( const)?) )?(struct|union|enum)( [A-Za-z0-9_]+)?$/)
	{
		in_enum = line ~ /enum/
		in_type = line ~ /^(typedef|static)/
		return ""
	}
	if (line ~ /^\}/)
	{
		in_enum = 0
		if (!in_type)
			return ""
		in_type = 0
		what = "object"
		sub(/^\} */, "", line)
		sub(/[^A-Za-z0-9_].*/, "", line)
		return line
	}
	if (line ~ /^(typedef )?enum.*\{.*\}/)
	{
		what = "object"
		name = line
		sub(/^[^{]*\{/, "", line)
		sub(/\}.*/, "", line)
		gsub(/=[^,]*/, "", line)
		gsub(/,/, " ", line)
		if (name ~ /^typedef/)
		{
			sub(/.*\} */, "", name)
			sub(/;.*/, "", name)
			line = line " " name
		}
		return line
	}
	if (line ~ /^typedef .*;$/)
	{
		what = "object"
		sub(/ *__attribute__.*/, "", line)
		if (line ~ /\(\*/)
		{
			sub(/.*\(\*/, "", line)
			sub(/\).*/, "", line)
		}
		else
		{
			sub(/[;\[(].*/, "", line)
			sub(/.*[ *]/, "", line)
		}
		return line
	}
	if (line ~ /^[A-Z_]*KERNEL\(/)
	{
		what = "kernel"
		sub(/^[A-Z_]*\(/, "", line)
		sub(/[,)].*/, "", line)
		return line
	}
	if (line ~ /^(static|[A-Z_]*INLINE|INLINE_LONG|INLINE_MEET|INLINE_SHORT|OUT_OF_LINE|RARE) /)
	{
		gsub(/__attribute__\(\([a-z_]*(\([^)]*\))?\)\) /, "", line)
		gsub(/ [A-Z]+\([0-9, ]*\)/, "", line)
		what = line ~ /^[^=\[]*\(/ ? "function" : "object"
		sub(/[;=(\[].*/, "", line)
		sub(/ +$/, "", line)
		sub(/.*[ *]/, "", line)
		return line
	}
	return ""
}

function add_kernel(name)
{
	wide_name[name "_item"] = wide_name[name "_listed"] = wide_name[name "_group"] = "function"
	kernel_name[name] = 1
}

# Notes the names that macros in a line make: kind##_load is contact_load and joint_load, SOLVES(goal) chain_goal and chains_goal.
function collect_pasted(line, k, name)
{
	while (match(line, /(X\()?kind##_[a-z_]+[(,]|X\([a-z_]+,|^INLINE [A-Za-z]+ SOLVES\([a-z]+\)/))
	{
		name = substr(line, RSTART, RLENGTH)
		line = substr(line, RSTART + RLENGTH)
		if (name ~ /SOLVES/)
		{
			gsub(/.*\(|\)/, "", name)
			wide_name["chain_" name] = wide_name["chains_" name] = "function"
		}
		else if (name ~ /kind##/)
			for (k = 1; k <= kind_count; ++k)
			{
				if (name ~ /^X/)
					add_kernel(kind_of[k] substr(name, 9, length(name) - 9))
				else
					wide_name[kind_of[k] substr(name, 7, length(name) - 7)] = "function"
			}
		else
			add_kernel(substr(name, 3, length(name) - 3))
	}
}

# Notes the names that a wide header defines, and those of the headers that it includes.
function collect(path, i, k, n, names, line, shared)
{
	if (path in collected)
		return
	collected[path] = 1
	read(path)
	in_enum = in_type = 0
	for (i = 1; i <= length_of[path]; ++i)
	{
		line = text[path, i]
		if (line ~ /^#include "/)
		{
			split(line, names, "\"")
			if (names[2] ~ /\.def$/ || is_wide(resolve(names[2])) && !is_opencl(names[2]))
				collect(resolve(names[2]))
			continue
		}
		if (is_shared(path, line))
			shared = 1
		n = split(declared(line), names, " ")
		if (shared && what != "macro")
			n = 0
		if (line ~ /^\}/)
			shared = 0
		for (k = 1; k <= n; ++k)
			if (what == "kernel")
				add_kernel(names[k])
			else if (what == "macro")
			{
				wide_macro[names[k]] = 1
				if (path !~ /\/dialect\/(dialect|c_words)\.h$/)
					macro_of_all[names[k]] = 1
			}
			else
				wide_name[names[k]] = what
		collect_pasted(line)
	}
}

# Returns a line without its comment.
function uncommented(line, out)
{
	out = ""
	while (match(line, /"([^"\\]|\\.)*"|'([^'\\]|\\.)*'|[ \t]*\/\/.*/))
	{
		if (substr(line, RSTART, RLENGTH) ~ /^[ \t]*\/\//)
			return out substr(line, 1, RSTART - 1)
		out = out substr(line, 1, RSTART + RLENGTH - 1)
		line = substr(line, RSTART + RLENGTH)
	}
	return out line
}

# Returns a line of a .c file with the names of `rename` replaced, except members of structs and texts in quotes.
function renamed(line, out, token, before)
{
	out = ""
	while (match(line, /"([^"\\]|\\.)*"|'([^'\\]|\\.)*'|\/\/.*|[A-Za-z_][A-Za-z0-9_]*/))
	{
		token = substr(line, RSTART, RLENGTH)
		before = out substr(line, 1, RSTART - 1)
		line = substr(line, RSTART + RLENGTH)
		if ((token in rename) && before !~ /(\.|->)$/)
			token = rename[token]
		out = before token
	}
	return out line
}

# Returns true for the definition of a variable that a header declares.
function defines_extern(path, line)
{
	if (path !~ /\.c$/ || line !~ /^[A-Za-z][^(]*(=|;)/)
		return 0
	sub(/ *[=;\[].*/, "", line)
	sub(/.*[ *]/, "", line)
	return line in extern_name
}

# Writes a file with the text of its includes. A header appears once, a wide one once for each number of lanes.
function inline(path, unit, i, line, names, depth, guard)
{
	read(path)
	if (unit == "")
		host_has[path] = 1
	if (path !~ /\.def$/)
		print "\n// ----- " substr(path, length(root) + 2) " -----\n"
	depth = 0
	guard = path ~ /\.h$/
	for (i = 1; i <= length_of[path]; ++i)
	{
		line = text[path, i]
		line = line ~ /\/\// ? uncommented(line) : line
		if (line == "")
			continue
		if (line ~ /^#[ ]*if/ && !(guard && line ~ /_H$/))
			++depth
		else if (line ~ /^#[ ]*endif/ && depth > 0)
			--depth
		if (line ~ /^#[ ]*include "/)
		{
			split(line, names, "\"")
			include(resolve(names[2]), unit, depth)
			continue
		}
		if (unit != "" && is_shared(path, line))
			in_shared = 1
		if (in_shared)
		{
			in_shared = line !~ /^\}/
			continue
		}
		if (path ~ /\.h$/)
		{
			sub(/^extern /, "static ", line)
			if (line ~ /^#define .* scree_status api_##/)
				sub(/ scree_status api_##/, " static scree_status api_##", line)
			if (line ~ /^\t+scree_status (api|metric)_##/) # goes on with such a macro
				sub(/scree_status/, "static scree_status", line)
			if (line ~ /^[A-Za-z][A-Za-z0-9_]*[ *].*[(,]/ && line !~ /^(static|typedef|struct|union|enum|INLINE|INLINE_LONG|INLINE_MEET|INLINE_SHORT|OUT_OF_LINE|RARE|_Static_assert|SCREE_API)/ && line !~ /^[A-Z_]+[( ]/ && line !~ /^void SELF_TEST/)
				line = "static " line
		}
		if (line ~ /^const [^(]*(=|\[)/ || defines_extern(path, line))
			line = "static " line
		if (path ~ /\.c$/)
			line = renamed(line)
		print line
	}
}

function include(path, unit, depth)
{
	if (path == "scree/scree.h")
	{
		print "#include \"scree/scree.h\""
		return
	}
	if (is_opencl(path))
		return
	if (path !~ /\.def$/ && (is_wide(path) ? ((path, unit) in included) : (path in included)))
		return
	if (unit != "" && path !~ /\.def$/ && !is_wide(path))
	{
		print "one_file.awk: the host does not include " path >"/dev/stderr"
		failed = 1
	}
	if (depth == 0)
		included[path] = included[path, unit] = 1
	inline(path, unit)
}

function stem_of(path)
{
	sub(/.*\//, "", path)
	sub(/\..*/, "", path)
	return path
}

# Notes the names that a header declares, and those of the headers that it includes.
function scan_header(path, i, k, n, names, line)
{
	if (path in scanned)
		return
	scanned[path] = 1
	read(path)
	in_enum = in_type = 0
	for (i = 1; i <= length_of[path]; ++i)
	{
		line = text[path, i]
		if (line ~ /^#[ ]*include "/)
		{
			scan_included(line)
			continue
		}
		n = split(declared(line), names, " ")
		for (k = 1; k <= n; ++k)
			declared_name[names[k]] = 1
		if (n == 0 && line ~ /^[A-Za-z][A-Za-z0-9_]*[ *].*[(,]/)
		{
			sub(/\(.*/, "", line)
			sub(/.*[ *]/, "", line)
			declared_name[line] = 1
		}
		else if (line ~ /^extern /)
		{
			sub(/ *[;,\[].*/, "", line)
			sub(/.*[ *]/, "", line)
			extern_name[line] = 1
		}
	}
}

# Notes the macros of a list, which keep their names, because the including file defines them.
function scan_list(path, i, name)
{
	read(path)
	for (i = 1; i <= length_of[path]; ++i)
		if (match(text[path, i], /^[ \t]*[A-Z_]+\(/))
		{
			name = text[path, i]
			gsub(/^[ \t]+|\(.*/, "", name)
			undefined[name] = 1
		}
}

function scan_included(line, names)
{
	split(line, names, "\"")
	if (names[2] ~ /\.def$/)
		scan_list(resolve(names[2]))
	else if (names[2] != "scree/scree.h")
		scan_header(resolve(names[2]))
}

# Counts the .c files that define a name.
function count_names(path, i, k, n, names, line)
{
	read(path)
	in_enum = in_type = 0
	for (i = 1; i <= length_of[path]; ++i)
	{
		if (text[path, i] ~ /^#[ ]*include "/)
			scan_included(text[path, i])
		n = split(declared(text[path, i]), names, " ")
		for (k = 1; k <= n; ++k)
		{
			++uses[names[k]]
			own[path] = own[path] " " names[k]
			if (what == "macro")
				macros[path] = macros[path] " " names[k]
		}
	}
}

function host(path, k, n, names)
{
	split("", rename)
	n = split(own[path], names, " ")
	for (k = 1; k <= n; ++k)
		if (uses[names[k]] > 1 || (names[k] in declared_name))
			rename[names[k]] = names[k] "_in_" stem_of(path)
	n = split(macros[path], names, " ")
	for (k = 1; k <= n; ++k)
		if (!(names[k] in declared_name) || (names[k] in undefined) || names[k] == "SELF_TEST")
			delete rename[names[k]]
	inline(path, "")
	for (k = 1; k <= n; ++k)
		print "#undef " (names[k] in rename ? rename[names[k]] : names[k])
	split("", rename)
}

# Some names are macros with one lane and functions with several.
function is_renamed(k, name) { return !(k in wide_macro) || (name !~ /^(lanes1|scalar_avx2)$/ && !(k in macro_of_all)) }

function unit(path, name, k)
{
	name = stem_of(path)
	print "\n// ----- names of " name " -----\n"
	print "#if " condition[name]
	if (name in instructions)
	{
		print "#ifdef __clang__"
		print "#pragma clang attribute push(__attribute__((target(\"" instructions[name] "\"))), apply_to = function)"
		print "#else\n#pragma GCC push_options\n#pragma GCC target(\"" instructions[name] "\")"
		if (name == "lanes16") # whose instructions can fuse
			print "#pragma GCC optimize(\"fp-contract=off\")\n#pragma GCC optimize(\"no-tree-slp-vectorize\")"
		print "#endif"
	}
	for (k in wide_macro)
		print "#undef " k
	print "#undef LANES\n#undef TABLE\n#undef SELF_TEST"
	for (k in wide_name)
		if (is_renamed(k, name) && k !~ /^(Word|Word64|Float2|Float4|Int2)$/)
			print "#define " k (wide_name[k] == "function" ? "(...) " k "_" name "(__VA_ARGS__)" : " " k "_" name)
	for (k in row_struct)
		print "#define " substr(k, 1, 0 + row_struct[k]) "_" name substr(k, 1 + row_struct[k]) " " k
	if (name == "scalar_avx2")
		for (k in kernel_name)
			print "#define " k "_lanes1 " k "_" name
	inline(path, name)
	for (k in wide_name)
		if (is_renamed(k, name))
			print "#undef " k
	if (name in instructions)
		print "#ifdef __clang__\n#pragma clang attribute pop\n#else\n#pragma GCC pop_options\n#endif"
	print "#endif"
}

function print_head(k, warnings)
{
	print "//\n// scree_all.c -- the CPU library of Scree as one file, written by tools/one_file.sh. docs/manual/building.md describes its options."
	print "#define _GNU_SOURCE\n#define SCREE_BUILDING\n#define SCREE_NO_OPENCL"
	print "// the numbers of lanes that are compiled, as a sum of 1, 4, 8 and 16; 8 and 16 are for x86-64"
	print "#ifndef SCREE_LANES\n#ifdef __x86_64__\n#define SCREE_LANES 29\n#else\n#define SCREE_LANES 5\n#endif\n#endif"
	print "#if SCREE_LANES < 1 || SCREE_LANES > 29 || SCREE_LANES & 2 || !(SCREE_LANES & 1)"
	print "#error \"scree: SCREE_LANES must be 1, or a sum of 1 and some of 4, 8 and 16\"\n#endif"
	print "#pragma GCC diagnostic ignored \"-Wunused-function\"\n#pragma GCC diagnostic ignored \"-Wunused-variable\"\n#pragma GCC diagnostic ignored \"-Wunused-const-variable\""
	print "#ifndef __clang__"
	# warnings of gcc that depend on what it inlines are for the separate files
	for (k = split("psabi maybe-uninitialized format-truncation stringop-overflow stringop-overread array-bounds", warnings, " "); k > 0; --k)
		print "#pragma GCC diagnostic ignored \"-W" warnings[k] "\""
	print "#endif"
}

BEGIN {
	condition["lanes1"] = "1"
	condition["lanes4"] = "SCREE_LANES & 4"
	condition["lanes8"] = "SCREE_LANES & 8"
	condition["lanes16"] = "SCREE_LANES & 16"
	condition["scalar_avx2"] = "SCREE_LANES >= 8"
	instructions["lanes8"] = instructions["scalar_avx2"] = "avx2"
	instructions["lanes16"] = "avx512f,avx512dq,avx512vl,avx512bw"
	print_head()
	for (k = 1; k < ARGC; ++k)
		files[k] = root "/" ARGV[k]
	count = ARGC - 1
	# Kind##Rows, where the name of the kind was replaced
	for (k = split("Rows RareRows Kept RareKept", ends, " "); k > 0; --k)
	{
		row_struct["Contact" ends[k]] = 7
		row_struct["Joint" ends[k]] = 5
	}
	kind_count = split("contact joint", kind_of, " ")
	for (k = 1; k <= count; ++k)
		if (!is_unit(files[k]))
			count_names(files[k])
	for (k = 1; k <= count; ++k)
		if (!is_unit(files[k]))
			host(files[k])
	for (k = 1; k <= count; ++k)
		if (is_unit(files[k]))
			collect(files[k])
	for (k = 1; k <= count; ++k)
		if (is_unit(files[k]))
			unit(files[k])
	exit failed
}
