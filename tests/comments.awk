# comments.awk -- prints comments that are not plain English, found by their first word, by the first word of a line or by
# a phrase: file:line: why: text.
#
# STYLE.md has the rule. Consecutive lines that begin with // are one comment; a comment behind code is one too.
function check(text, first)
{
	gsub(/`[^`]*`|"[^"]*"/, "CODE", text)
	first = tolower(text)
	sub(/^[^a-z]*/, "", first)
	if (match(first, /^(of|what|where|how|so many|so much|whose|whether what)[^a-z_]/))
		report("begins with " substr(first, 1, RLENGTH - 1))
	if (match(first, /(^|[^a-z])(so many|so much|anew|as ever|is none any more|any more|no more|it knows|knows|know|asks|asked|tells|told|wants|wanted|want of|who)([^a-z_]|$)/))
		report("says" substr(first, RSTART, RLENGTH))
}
function report(why) { printf "%s:%d: %s: %s\n", FILENAME, start, why, shown }
function flush() { if (comment != "") { shown = substr(comment, 1, 100); check(comment) } comment = "" }
FNR == 1 { flush() }
{
	line = $0
	at = match(line, /(^|[ \t;,{})])\/\/ /)
	if (!at) { flush(); next }
	before = substr(line, 1, RSTART)
	text = substr(line, RSTART + RLENGTH)
	if (text ~ /^SPDX-License-Identifier/) { flush(); next }
	if (before ~ /[^ \t\/]/) { flush(); start = FNR; comment = text; flush(); next }
	if (comment == "") start = FNR
	else if (tolower(text) ~ /^(of|what|where|so many)([^a-z_]|$)/)
		printf "%s:%d: a line begins with %s\n", FILENAME, FNR, text
	comment = comment (comment == "" ? "" : " ") text
	if (FNR == 2) sub(/^[^ ]+ -- /, "", comment)
}
END { flush() }
