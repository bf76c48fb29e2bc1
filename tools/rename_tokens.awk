# rename_tokens.awk -- splits a file of C, C++ or JavaScript into tokens, for rename.awk.
#
# Tokens are identifiers, numbers, spaces, signs, keys (JavaScript strings that are one identifier), and text (comments and other
# strings). Token k has text[k], kind[k] and line[k]; code[c] is the index k of the c-th token that is an identifier, a number, a
# sign or a key.

function add(token, k)
{
	text[++tokens] = token
	kind[tokens] = k
	line[tokens] = FNR
	if (k == "name" || k == "number" || k == "sign" || k == "key")
		code[++codes] = tokens
	if (k == "name" || k == "number" || k == "sign")
	{
		before = last
		last = token
		last_kind = k
	}
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

# Adds a string that is complete. A JavaScript string that is one identifier is a key, because it may name a member.
function add_string(string, quote)
{
	if (language == "js" && string ~ /^["'`][A-Za-z_$][A-Za-z_0-9$]*["'`]$/)
	{
		quote = substr(string, 1, 1)
		add(quote, "text")
		add(substr(string, 2, length(string) - 2), "key")
		add(quote, "text")
	}
	else
		add_text(string)
	end_string()
}

# Makes the last string or template the token before the next one. A slash behind it divides.
function end_string()
{
	before = last
	last = last_kind = "string"
}

# Returns the length of the string at the beginning of rest, up to its closing quote on this line. A string that ends with a
# backslash goes on in the next line.
function string_length(rest)
{
	open_quote = ""
	if (rest ~ /^"/ ? match(rest, /^"([^"\\]|\\.)*"/) : match(rest, /^'([^'\\]|\\.)*'/))
		return RLENGTH
	if (rest ~ /\\\r?$/)
		open_quote = substr(rest, 1, 1)
	return length(rest)
}

# Stores the end of the raw string of C++ at the beginning of rest, and returns the length of its beginning: R"END(
function raw_length(rest)
{
	if (language != "c" || !match(rest, /^(u8|u|U|L)?R"[^ ()\\\t"]*\(/))
		return 0
	raw_end = substr(rest, 1, RLENGTH - 1)
	sub(/^[^"]*"/, "", raw_end)
	raw_end = ")" raw_end "\""
	return RLENGTH
}

# Returns whether a slash begins a regular expression of JavaScript. It divides behind a value; rest begins with the slash.
function begins_regex(rest)
{
	if (last_kind == "name")
		return before != "." && last ~ /^(return|typeof|case|in|instanceof|delete|void|throw|new|do|else|yield)$/
	if (last == ">")
		return before == "="
	if (last == ")")
		return head_closed
	if (last == "}")
		return rest !~ /^\/[ \t]*>/
	if (last ~ /^[-+]$/)
		return before != last
	return last == "" || last ~ /^[(,=:[!&|?{;*%~^]$/
}

# Returns the length of the regular expression at the beginning of rest, with its flags, or 0 if it does not end on this line.
function regex_length(rest)
{
	return match(rest, /^\/([^\/\\[]|\\.|\[([^]\\]|\\.)*\])+\/[a-z]*/) ? RLENGTH : 0
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
			end_string()
			if (c == "${")
			{
				braces[++templates] = 0
				last = "{"
			}
			return c == "${" ? k + 1 : k
		}
	}
	return length(rest)
}

# Counts the braces of the code in a template; the last closing brace returns to the text of the template. Stores whether a
# closing parenthesis ends the head of a statement, because a slash behind it begins a regular expression.
function read_bracket(sign)
{
	if (sign == "(")
		head[++parentheses] = last ~ /^(if|while|for|with)$/
	else if (sign == ")" && parentheses > 0)
		head_closed = head[parentheses--]
	else if (sign == "}" && templates > 0 && braces[templates]-- == 0)
	{
		--templates
		in_template = 1
	}
	else if (sign == "{" && templates > 0)
		++braces[templates]
}

function read_line(rest, n, k)
{
	if (rest == "")
		open_quote = in_line_comment = ""
	while (rest != "")
	{
		if (in_template)
			add_text(substr(rest, 1, n = template_length(rest)))
		else if (raw_end != "")
		{
			k = index(rest, raw_end)
			n = k ? k + length(raw_end) - 1 : length(rest)
			add_text(substr(rest, 1, n))
			if (k)
				raw_end = ""
		}
		else if (open_quote != "")
			add_text(substr(rest, 1, n = string_length(open_quote rest) - 1))
		else if (in_line_comment || (!in_comment && rest ~ /^\/\//))
		{
			in_line_comment = language == "c" && rest ~ /\\\r?$/
			add_text(substr(rest, 1, n = length(rest)))
		}
		else if (in_comment)
		{
			n = index(rest, "*/")
			in_comment = n == 0
			n = n ? n + 1 : length(rest)
			add_text(substr(rest, 1, n))
		}
		else if (language == "js" && match(rest, /^`[A-Za-z_$][A-Za-z_0-9$]*`/))
			add_string(substr(rest, 1, n = RLENGTH))
		else if (language == "js" && rest ~ /^`/)
		{
			in_template = 1
			add_text(substr(rest, 1, n = 1))
		}
		else if (rest ~ /^[uUL8]*R"/ && (n = raw_length(rest)))
			add_text(substr(rest, 1, n))
		else if (match(rest, /^[A-Za-z_$][A-Za-z_0-9$]*/))
			add(substr(rest, 1, n = RLENGTH), "name")
		else if (match(rest, /^[0-9][0-9A-Za-z_.']*/))
			add(substr(rest, 1, n = RLENGTH), "number")
		else if (match(rest, /^[ \t\r]+/))
			add(substr(rest, 1, n = RLENGTH), "space")
		else if (rest ~ /^\/\*/)
		{
			in_comment = 1
			add("/*", "text")
			n = 2
		}
		else if (rest ~ /^["']/)
			add_string(substr(rest, 1, n = string_length(rest)))
		else if (language == "js" && rest ~ /^\// && begins_regex(rest) && (n = regex_length(rest)))
		{
			add_text(substr(rest, 1, n))
			end_string()
		}
		else if (rest ~ /^->/)
			add(substr(rest, 1, n = 2), "sign")
		else
		{
			read_bracket(substr(rest, 1, 1))
			add(substr(rest, 1, n = 1), "sign")
		}
		rest = substr(rest, n + 1)
	}
	add("\n", "space")
}

input == 2 { read_line($0) }

function at(c) { return c >= 1 && c <= codes ? text[code[c]] : "" }
# Returns whether token c is an identifier, but no keyword that stands before expressions or types.
function is_name(c) { return c >= 1 && c <= codes && kind[code[c]] == "name" && at(c) !~ no_name }

BEGIN {
	no_name = "^(const|volatile|restrict|return|else|case|goto|sizeof|struct|new|delete|throw|co_return|co_yield|co_await)$"
}
