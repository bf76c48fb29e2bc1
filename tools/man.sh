#!/bin/sh
# SPDX-License-Identifier: MIT
# man.sh -- writes the manual page of the command line, scree.1, from the help that it prints itself.
#
# usage: tools/man.sh SCREE FILE
. "$(dirname "$0")/usage.sh"
set -eu
scree=${1:?is the path of the command line} file=${2:?is the path of the page}
exec >"$file"

# escapes the signs that troff would interpret
escape()
{
	sed 's/\\/\\e/g; s/-/\\-/g; s/^\([.'"'"']\)/\\\&\1/'
}

# options_of COMMAND...: the lines "-x, --name VALUE   text" of a help as paragraphs with tags
options_of()
{
	"$scree" "$@" --help | escape | awk '
		/^ +\\-/ {
			sub(/^ +/, "")
			gap = match($0, /  +/)
			print ".TP\n.B " (gap ? substr($0, 1, gap - 1) : $0)
			if (gap)
				print substr($0, gap + RLENGTH)
			next
		}
		/^ +[^ ]/ && !/^ +scree / { sub(/^ +/, ""); print }'
}

echo ".TH SCREE 1 \"\" \"$("$scree" --version)\" \"User Commands\""
echo ".SH NAME"
"$scree" --help | sed -n '1s/^scree [^ ]* -- /scree \\- /p'
echo ".SH SYNOPSIS"
"$scree" --help | escape | awk '/^  scree / { sub(/^ +/, ""); gap = match($0, /  +/); print ".B " substr($0, 1, gap - 1) "\n.br" }'
echo ".SH DESCRIPTION"
"$scree" --help | escape | awk '/^  scree /{ next } NR > 1 && NF { print; text = 1 } !NF && text { print ".PP" }'
echo ".SH COMMANDS"
"$scree" --help | sed -n 's/^  \(scree [a-z]*\( [a-z]*\)\{0,1\}\)[^a-z].*/\1/p' | while read -r name command form; do
	[ "$command" != help ] || continue
	echo ".SS $name $command${form:+ $form}"
	"$scree" --help | escape | awk -v start="  scree $command${form:+ $form}" '
		index($0, start) == 1 && (substr($0, length(start) + 1, 1) ~ /[^a-z]/) {
			sub(/^ +/, ""); gap = match($0, /  +/); rest = substr($0, gap + RLENGTH)
			if (!done++) print ".B " substr($0, 1, gap - 1) "\n.br\n" rest }'
	# the words must be split
	options_of $command $form
done
echo ".SH FILES"
echo "Scenes are installed in share/scree/scenes, the library's manual is the header scree/scree.h."
