# rename.awk -- ports one file to the new names: prints the changed file, and writes ambiguous names to the file `report`.
#
# usage: awk -v language=c|js -v file=NAME -v report=FILE -v open_end=0|1 -f rename.awk -f rename_tokens.awk -f rename_c.awk
#        -f rename_js.awk docs/manual/names.md FILE
#
# The first file, docs/manual/names.md, has the tables of names. rename_tokens.awk splits the second into tokens. open_end is 1 if its last
# line has no newline. tools/rename.sh runs this script.

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

END {
	if (language == "c")
		port_c()
	else
		port_js()
	for (k = 1; k <= tokens - open_end; ++k)
		printf "%s", kind[k] ~ /^(name|word|key)$/ && (text[k] in whole) ? whole[text[k]] : text[k]
}
