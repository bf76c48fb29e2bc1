# rename_c.awk -- changes the members of structs in C and C++, for rename.awk: finds the types of variables and of initializers.

function type_of(name) { return name in whole ? whole[name] : name }

# Returns the new name of the type at c, or "?" if the type is that of a namespace or a class.
function type_at(c)
{
	return at(c - 1) == ":" && at(c - 2) == ":" && (is_name(c - 3) || at(c - 3) == ">") ? "?" : type_of(at(c))
}
function is_struct(c) { return type_at(c) in struct }

function declares(name, type)
{
	if ((name in declared) && declared[name] != type)
		type = "?"
	declared[name] = type
}

# Skips an initializer. Returns the index of the sign that ends the declarator whose name is before token c: , ; or a bracket.
# Behind arguments and braces, this is the next token, because it may be the body of a function or of a namespace.
function past_initializer(c, depth, closed)
{
	closed = at(c) ~ /^[({]$/
	if (at(c) == ">")
		return c
	for (; c <= codes; ++c)
	{
		if (depth == 0 && at(c) ~ /^[;,)}]$/)
			return c
		depth += at(c) ~ /^[([{]$/ ? 1 : at(c) ~ /^[])}]$/ ? -1 : 0
		if (closed && depth == 0)
			return c + 1
	}
	return c
}

function past_pointers(c)
{
	while (at(c) ~ /^(\*|&|const|volatile|restrict)$/)
		++c
	return c
}

function is_declarator(c)
{
	return is_name(c) && at(c + 1) ~ /^([;,=[({):>]|__attribute__|asm)$/
}

# Stores the type of the variable at c, and of further variables after commas.
function read_declarators(c, type)
{
	while (is_declarator(c))
	{
		declares(at(c), type)
		c = past_initializer(c + 1)
		if (at(c) != ",")
			break
		c = past_pointers(c + 1)
	}
}

# Returns the index of the bracket that opens the one at c, or 0 if a statement begins between them.
function opening(c, close_sign, open_sign, depth, angles)
{
	close_sign = at(c)
	open_sign = close_sign == ">" ? "<" : "("
	for (; c >= 1; --c)
	{
		if (depth == 0 && at(c) ~ /^[<>]$/ && open_sign == "<")
			angles += at(c) == ">" ? 1 : -1
		depth += at(c) ~ /^[])}]$/ ? 1 : at(c) ~ /^[([{]$/ ? -1 : 0
		if (depth < 0 || (depth == 0 && at(c) == ";"))
			return 0
		if (depth == 0 && angles == 0 && at(c) == open_sign)
			return c
	}
	return 0
}

# Returns whether the bracket at c ends a type: TYPE<...> or decltype(...), not the head of a statement or a cast.
function ends_type(c)
{
	c = opening(c)
	return c > 0 && is_name(c - 1) && at(c - 1) !~ /^(if|while|for|switch|constexpr|defined)$/
}

# Stores names up to the bracket at the end of a list that begins at c. In a list of captures, only those with = are variables.
function read_list(c, captures, depth)
{
	for (; c <= codes && at(c) != ";"; ++c)
	{
		depth += at(c) ~ /^[([{]$/ ? 1 : at(c) ~ /^[])}]$/ ? -1 : 0
		if (depth == 0)
			break
		if (depth == 1 && is_name(c) && (!captures || (at(c + 1) == "=" && at(c - 1) ~ /^[[,&]$/)))
			declares(at(c), "?")
	}
}

# Marks the parameters in the text of a macro, because they may be objects of any type. The parameters begin at c.
function read_macro(c, parameter)
{
	for (; c <= codes && at(c) != ")"; ++c)
		parameter[at(c)] = 1
	for (++c; c <= codes && (line[code[c]] == line[code[c - 1]] || at(c - 1) == "\\"); ++c)
		if (at(c) in parameter)
			no_variable[c] = 1
}

# Stores the types of variables that the file declares: TYPE [*&const]... NAME, and further names after commas. The type is "?" for
# two types, templates, decltype, structs without a name, pointers in parentheses, [a, b] of auto, captures and macros.
function find_declarations(c, d)
{
	for (c = 1; c <= codes; ++c)
	{
		if (is_name(c))
		{
			d = past_pointers(c + 1)
			if (at(c) == "define" && at(c - 1) == "#")
			{
				declares(at(c + 1), "?")
				if (at(c + 2) == "(" && code[c + 2] == code[c + 1] + 1)
					read_macro(c + 3)
			}
			else if ((d > c + 1 || is_name(d)) && is_declarator(d))
				read_declarators(d, type_at(c))
			else if (at(c) == "auto" && at(d) == "[")
				read_list(d, 0)
			else if (at(c + 1) == "(" && at(c + 2) ~ /^[*&]$/ && !(at(c) ~ /^(if|while|for|switch)$/))
			{
				d = past_pointers(c + 2)
				if (is_name(d) && at(d + 1) == ")" && at(d + 2) ~ /^[[(]$/)
					declares(at(d), "?")
			}
		}
		else if (at(c) ~ /^[>)}]$/)
		{
			d = past_pointers(c + 1)
			if (is_declarator(d) && (at(c) == "}" ? at(d + 1) != "(" : ends_type(c)))
				read_declarators(d, "?")
		}
		else if (at(c) == "[" && !is_name(c - 1) && at(c - 1) !~ /^[])]$/)
			read_list(c, 1)
	}
}

# Returns the name of the struct that the brace at c initializes, with "[]" after it for an array, or "" if it is unknown.
function braced(c, array, d)
{
	d = c - 1
	if (at(d) == ")") # (TYPE){ or (TYPE[]){
	{
		for (--d; at(d) ~ /^([\]\[*]|const)$/ || (d > 0 && kind[code[d]] == "number"); --d)
			array = array (at(d) == "[" ? "[]" : "")
		return at(d - 1) ~ /^(\(|const|struct|:)$/ && is_struct(d) ? type_at(d) array : ""
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
	if (is_name(d) && is_struct(d - 1)) # TYPE NAME = {
		return type_at(d - 1) array
	if (array == "" && d == c - 1 && is_struct(d)) # TYPE{
		return type_at(d)
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
	if (!is_name(c) || (c in no_variable) || at(c - 1) ~ /^(\.|->)$/ || (at(c - 1) == ":" && at(c - 2) == ":"))
		return ""
	return (at(c) in declared) && (declared[at(c)] in struct) ? declared[at(c)] : ""
}

# Changes the member of offsetof(TYPE, MEMBER); c is the parenthesis. Stores the member, because it is not a variable.
function port_offsetof(c, type, depth)
{
	type = at(c + 1) == "struct" ? c + 2 : c + 1
	for (; c <= codes && at(c) != ";"; ++c)
	{
		depth += at(c) ~ /^[([{]$/ ? 1 : at(c) ~ /^[])}]$/ ? -1 : 0
		if (depth == 0)
			return
		if (depth == 1 && at(c) == "," && is_name(c + 1))
		{
			no_variable[c + 1] = 1
			port_member(c + 1, c == type + 1 && is_struct(type) ? type_at(type) : "")
			return
		}
	}
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
		else if (at(c) ~ /^(__builtin_)?offsetof$/ && at(c + 1) == "(")
			port_offsetof(c + 1)
		else if (at(c) == ":" && at(c + 1) == ":" && (is_name(c - 1) || at(c - 1) == ">") && is_name(c + 2))
			port_member(c + 2, is_struct(c - 1) ? type_at(c - 1) : "")
		else if (at(c) == "," && is_struct(c - 1) && is_name(c + 1) && !(c + 1 in no_variable)) # MACRO(x, TYPE, NAME)
			port_member(c + 1, "")
		else if (at(c) == "." && at(c - 1) ~ /^[{,]$/ && is_name(c + 1))
			port_member(c + 1, type[depth])
		else if (at(c) ~ /^(\.|->)$/ && at(c - 1) != "." && is_name(c + 1))
			port_member(c + 1, object(c))
	}
}
