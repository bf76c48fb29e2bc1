# rename_js.awk -- changes the members of objects in JavaScript, for rename.awk: behind dots, in [], and as keys.

# Stores for each token of JavaScript the bracket around it, and for each bracket its end.
function find_brackets(c, depth, stack)
{
	for (c = 1; c <= codes; ++c)
	{
		around[c] = depth > 0 ? stack[depth] : 0
		if (kind[code[c]] != "sign")
			continue
		if (at(c) ~ /^[([{]$/)
			stack[++depth] = c
		else if (at(c) ~ /^[])}]$/ && depth > 0)
			end[stack[depth--]] = c
	}
}

# Returns whether the brace at c begins an object or a pattern, not statements, a class, a type, imports, exports or JSX.
function is_object(c)
{
	if (at(c) != "{")
		return 0
	if (at(c - 1) == "=")
		return at(c - 3) ~ /^(const|let|var|[:.;,(]|)$/
	return at(c - 1) ~ /^(const|let|var|return|throw|yield|default|of|in|[(,:[?&|.])$/
}

# Returns whether the brace at c begins a pattern for the members of the object: {...} = [NAME.]OBJECT, or OBJECT: {...}.
function is_pattern_of(c, name, d)
{
	if (at(c - 1) == ":")
		return at(c - 2) == name
	d = end[c] + 1
	if (at(c) != "{" || !(c in end) || at(d) != "=")
		return 0
	for (++d; at(d + 1) == "."; d += 2)
		;
	return at(d) == name && at(d + 1) !~ /^[[(?]$/
}

# Returns the position of the name or string at c: member behind a dot or in [], key before a colon, short for {NAME} and
# {NAME = VALUE}, or "". Stores the token before the dot in holder.
function position(c, d)
{
	holder = ""
	if (kind[code[c]] == "key")
	{
		if (at(c - 1) == "[" && at(c + 1) == "]")
		{
			d = c - 2
			if (at(c + 2) == ":" && at(d) ~ /^[{,]$/)
				return "key"
			if (at(d) == "." && at(d - 1) == "?")
				d -= 2
			else if (!is_name(d) && at(d) !~ /^[])]$/ && at(d) != "!")
				return ""
			holder = at(d)
			return "member"
		}
		return at(c + 1) == "in" ? "member" : at(c + 1) == ":" && at(c - 1) ~ /^[{,;]$/ ? "key" : ""
	}
	if (at(c - 1) == ".")
	{
		holder = at(c - 2) == "?" ? at(c - 3) : at(c - 2)
		return at(c - 2) == "." ? "" : "member"
	}
	if (at(c + 1) == ":" || (at(c + 1) == "?" && at(c + 2) == ":"))
		return "key"
	if (at(around[c]) != "{" || at(c - 1) !~ /^[{,]$/)
		return ""
	return at(c + 1) ~ /^[,}]$/ || (at(c + 1) == "=" && is_object(around[c])) ? "short" : ""
}

# Changes a name of JavaScript if its object is certain, otherwise reports it. {NAME} becomes {NEW: NAME}, because NAME is also a
# variable.
function port_name(c, where, brace, certain, new)
{
	where = position(c)
	brace = around[where == "key" && at(c - 1) == "[" ? c - 1 : c]
	if (where == "")
	{
		if ((at(c) in doubtful) && kind[code[c]] == "name")
			leave(c, doubtful[at(c)])
		return
	}
	if (at(c) in owned)
	{
		new = owned[at(c)]
		certain = where == "member" ? holder == owner[at(c)] : is_pattern_of(brace, owner[at(c)])
	}
	else if (at(c) in sure)
	{
		new = sure[at(c)]
		certain = where == "member" || (is_object(brace) && at(c - 1) ~ /^[{,[]$/)
	}
	else
		new = at(c) in doubtful ? doubtful[at(c)] : unsure[at(c)]
	if (certain)
		text[code[c]] = where == "short" ? new ": " at(c) : new
	else
		leave(c, new)
}

function port_js(c, k)
{
	find_brackets()
	for (c = 1; c <= codes; ++c)
	{
		k = kind[code[c]]
		if ((k == "name" || k == "key") && (at(c) in owned || at(c) in doubtful || at(c) in sure || at(c) in unsure))
			port_name(c)
	}
}
