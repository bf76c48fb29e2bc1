# rename.awk -- ports one file to the new names: prints the changed file, and writes ambiguous names to the file `report`.
#
# usage: awk -v language=c|js -v file=NAME -v report=FILE -v open_end=0|1 -f rename.awk docs/names.md FILE
#
# The first file, docs/names.md, has the tables of names. The second is split into tokens: identifiers, numbers, spaces, signs, and
# text (comments and strings). open_end is 1 if its last line has no newline. tools/rename.sh runs this script.

# ---------------------------------------------------------------------------------------------------------------
# the tables
# ---------------------------------------------------------------------------------------------------------------

# Returns the text between the first two back quotes of a cell.
function quoted(cell)
{
	return split(cell, part, "`") > 2 ? part[2] : ""
}

function read_row(cell, old, new, key)
{
	if (section ~ /^Functions/)
	{
		whole[quoted(cell[2])] = quoted(cell[3])
		return
	}
	if (section ~ /^Members/ && language == "c")
	{
		old = quoted(cell[3])
		new = quoted(cell[4])
		member[quoted(cell[2]), old] = new
		struct[quoted(cell[2])] = 1
		add_member(old, new, cell[5] ~ /everywhere/)
	}
	if (section ~ /^JavaScript/ && language == "js")
	{
		old = quoted(cell[2])
		new = quoted(cell[3])
		if (sub(/^\./, "", old))
			add_member(old, substr(new, 2), cell[4] ~ /everywhere/)
		else if (old ~ /\./)
		{
			split(old, part, ".")
			owner[part[2]] = part[1]
			owned[part[2]] = substr(new, index(new, ".") + 1)
		}
		else if (cell[4] ~ /everywhere/)
			whole[old] = new
		else
			doubtful[old] = new
	}
}

function add_member(old, new, everywhere)
{
	if (everywhere)
		sure[old] = new
	else if (!(old in unsure))
		unsure[old] = new
	else if (index(" " unsure[old] " ", " " new " ") == 0)
		unsure[old] = unsure[old] " or " new
}

FNR == 1 { ++input }
input == 1 && /^## / { section = substr($0, 4) }
input == 1 && /^\| `/ { split($0, cell, "|"); read_row(cell) }

# ---------------------------------------------------------------------------------------------------------------
# the tokens: text[k], kind[k] and line[k]; code[c] is the index k of the c-th token that is not space, comment or string
# ---------------------------------------------------------------------------------------------------------------

function add(token, k)
{
	text[++tokens] = token
	kind[tokens] = k
	line[tokens] = FNR
	if (k == "name" || k == "number" || k == "sign")
		code[++codes] = tokens
}

# Splits the text of a comment or a string into names and other text, because names of the first table are changed there too.
function add_text(rest)
{
	while (match(rest, /[A-Za-z_$][A-Za-z_0-9$]*/))
	{
		if (RSTART > 1)
			add(substr(rest, 1, RSTART - 1), "text")
		add(substr(rest, RSTART, RLENGTH), "word")
		rest = substr(rest, RSTART + RLENGTH)
	}
	if (rest != "")
		add(rest, "text")
}

# Returns the length of the string at the beginning of rest, up to its closing quote on this line.
function string_length(rest, quote, k)
{
	quote = substr(rest, 1, 1)
	for (k = 2; k <= length(rest); ++k)
	{
		if (substr(rest, k, 1) == "\\")
			++k
		else if (substr(rest, k, 1) == quote)
			return k
	}
	return length(rest)
}

# Returns the length of the text part of a JavaScript template: up to the end of the template, or up to and including the next ${,
# which code follows.
function template_length(rest, k, c)
{
	for (k = 1; k <= length(rest); ++k)
	{
		c = substr(rest, k, 2)
		if (c ~ /^\\/)
			++k
		else if (c ~ /^`/ || c == "${")
		{
			in_template = 0
			if (c == "${")
				braces[++templates] = 0
			return c == "${" ? k + 1 : k
		}
	}
	return length(rest)
}

# Counts the braces of the code in a template; the last closing brace returns to the text of the template.
function read_brace(sign)
{
	if (sign == "}" && templates > 0 && braces[templates]-- == 0)
	{
		--templates
		in_template = 1
	}
	else if (sign == "{" && templates > 0)
		++braces[templates]
}

function read_line(rest, n)
{
	while (rest != "")
	{
		if (in_template)
			add_text(substr(rest, 1, n = template_length(rest)))
		else if (language == "js" && rest ~ /^`/)
		{
			in_template = 1
			add_text(substr(rest, 1, n = 1))
		}
		else if (in_comment)
		{
			n = index(rest, "*/")
			in_comment = n == 0
			n = n ? n + 1 : length(rest)
			add_text(substr(rest, 1, n))
		}
		else if (match(rest, /^[A-Za-z_$][A-Za-z_0-9$]*/))
			add(substr(rest, 1, n = RLENGTH), "name")
		else if (match(rest, /^[0-9][0-9A-Za-z_.']*/))
			add(substr(rest, 1, n = RLENGTH), "number")
		else if (match(rest, /^[ \t\r]+/))
			add(substr(rest, 1, n = RLENGTH), "space")
		else if (rest ~ /^\/\//)
			add_text(substr(rest, 1, n = length(rest)))
		else if (rest ~ /^\/\*/)
		{
			in_comment = 1
			add("/*", "text")
			n = 2
		}
		else if (rest ~ /^["']/)
			add_text(substr(rest, 1, n = string_length(rest)))
		else if (rest ~ /^->/)
			add(substr(rest, 1, n = 2), "sign")
		else
		{
			add(substr(rest, 1, n = 1), "sign")
			read_brace(substr(rest, 1, 1))
		}
		rest = substr(rest, n + 1)
	}
	add("\n", "space")
}

input == 2 { read_line($0) }

# ---------------------------------------------------------------------------------------------------------------
# declarations and initializers
# ---------------------------------------------------------------------------------------------------------------

function at(c) { return c >= 1 && c <= codes ? text[code[c]] : "" }
function is_name(c) { return c >= 1 && c <= codes && kind[code[c]] == "name" && at(c) !~ /^(const|volatile|restrict|return|else|case|goto|sizeof|struct|new|delete)$/ }
function type_of(name) { return name in whole ? whole[name] : name }

function declares(name, type)
{
	if ((name in declared) && declared[name] != type)
		type = "?"
	declared[name] = type
}

# Skips an initializer. Returns the index of the sign that ends the declarator: a comma, a semicolon or a closing bracket. c:
# index of the token after the declared name.
function past_initializer(c, depth)
{
	for (; c <= codes; ++c)
	{
		if (depth == 0 && at(c) ~ /^[;,)}]$/)
			return c
		depth += at(c) ~ /^[([{]$/ ? 1 : at(c) ~ /^[])}]$/ ? -1 : 0
	}
	return c
}

# Stores the types of variables that the file declares: TYPE [*&const]... NAME, and further names after commas.
function find_declarations(c, d, type)
{
	for (c = 1; c <= codes; ++c)
	{
		if (at(c) == "}" && is_name(c + 1))
			declares(at(c + 1), "?")
		if (!is_name(c))
			continue
		type = type_of(at(c))
		for (d = c + 1; at(d) ~ /^(\*|&|const|volatile|restrict)$/; ++d)
			;
		if (d == c + 1 && !is_name(d))
			continue
		while (is_name(d) && at(d + 1) ~ /^[;,=[){:]$/)
		{
			declares(at(d), type)
			d = past_initializer(d + 1)
			if (at(d) != ",")
				break
			for (++d; at(d) == "*"; ++d)
				;
		}
	}
}

# Returns the name of the struct that the brace at token c initializes, with "[]" after it for an array, or "" if it is unknown.
function braced(c, array, d)
{
	d = c - 1
	if (at(d) == ")") # (TYPE){ or (TYPE[]){
	{
		for (--d; at(d) ~ /^([\]\[*]|const)$/ || (d > 0 && kind[code[d]] == "number"); --d)
			array = array (at(d) == "[" ? "[]" : "")
		return at(d - 1) ~ /^(\(|const|struct)$/ && type_of(at(d)) in struct ? type_of(at(d)) array : ""
	}
	if (at(d) == "=")
		--d
	while (at(d) == "]")
	{
		for (--d; d > 0 && at(d) != "["; --d)
			;
		--d
		array = "[]"
	}
	if (is_name(d) && type_of(at(d - 1)) in struct) # TYPE NAME = {
		return type_of(at(d - 1)) array
	if (array == "" && d == c - 1 && type_of(at(d)) in struct) # TYPE{
		return type_of(at(d))
	return ""
}

# Returns the name of the struct of the object before token c, which is "." or "->", or "" if it is unknown.
function object(c, depth)
{
	for (--c; at(c) == "]"; --c)
		for (depth = 0; c > 0; --c)
		{
			depth += at(c) == "]" ? 1 : at(c) == "[" ? -1 : 0
			if (depth == 0)
				break
		}
	if (!is_name(c) || at(c - 1) ~ /^(\.|->)$/)
		return ""
	return (at(c) in declared) && (declared[at(c)] in struct) ? declared[at(c)] : ""
}

# ---------------------------------------------------------------------------------------------------------------
# the names
# ---------------------------------------------------------------------------------------------------------------

function leave(c, new)
{
	printf "%s:%d: %s may be %s instead\n", file, line[code[c]], at(c), new >report
}

function port_member(c, type)
{
	if (at(c) in sure)
		text[code[c]] = sure[at(c)]
	else if (!(at(c) in unsure))
		return
	else if (type == "")
		leave(c, unsure[at(c)])
	else if ((type, at(c)) in member)
		text[code[c]] = member[type, at(c)]
}

function port_c(c, depth, type, element)
{
	find_declarations()
	for (c = 1; c <= codes; ++c)
	{
		if (at(c) == "{")
		{
			element = ""
			if (type[depth] ~ /\[\]$/ && at(c - 1) ~ /^[{,=]$/)
			{
				element = type[depth]
				sub(/\[\]$/, "", element)
			}
			else
				element = braced(c)
			type[++depth] = element
		}
		else if (at(c) == "}")
			delete type[depth--]
		else if (at(c) == "offsetof" && at(c + 3) == "," && (type_of(at(c + 2)) in struct))
			port_member(c + 4, type_of(at(c + 2)))
		else if (at(c) == "." && at(c - 1) ~ /^[{,]$/ && is_name(c + 1))
			port_member(c + 1, type[depth])
		else if (at(c) ~ /^(\.|->)$/ && is_name(c + 1))
			port_member(c + 1, object(c))
	}
}

function port_js(c)
{
	for (c = 1; c <= codes; ++c)
	{
		if (!is_name(c))
			continue
		if (at(c - 1) == "." && (at(c) in owned) && at(c - 2) == owner[at(c)])
			text[code[c]] = owned[at(c)]
		else if (at(c - 1) == "." || at(c + 1) == ":" || (at(c - 1) ~ /^[{,]$/ && at(c + 1) ~ /^[,}]$/))
		{
			if (at(c) in doubtful)
				leave(c, doubtful[at(c)])
			else
				port_member(c, "")
		}
		else if (at(c) in doubtful)
			leave(c, doubtful[at(c)])
	}
}

END {
	if (language == "c")
		port_c()
	else
		port_js()
	for (k = 1; k <= tokens - open_end; ++k)
		printf "%s", (kind[k] == "name" || kind[k] == "word") && (text[k] in whole) ? whole[text[k]] : text[k]
}
