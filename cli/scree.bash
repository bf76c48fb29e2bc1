# SPDX-License-Identifier: MIT
# scree.bash -- completion of the command line in bash: commands, options and scenes, as the program itself prints them.

_scree()
{
	local program=${COMP_WORDS[0]} word=${COMP_WORDS[COMP_CWORD]} command=${COMP_WORDS[1]-} words=
	COMPREPLY=()
	if [ "$COMP_CWORD" -eq 1 ]; then
		words="$("$program" --help 2>/dev/null | sed -n 's/^  scree \([a-z]*\).*/\1/p') --help --version"
	elif [[ $word == -* ]]; then
		words=$("$program" "$command" --help 2>/dev/null | sed -n 's/^  -., \(--[a-z-]*\).*/\1/p')
	else
		case $command in
		run | view | hash | bench) words=$("$program" scenes --names 2>/dev/null) ;;
		help) words=$("$program" --help 2>/dev/null | sed -n 's/^  scree \([a-z]*\).*/\1/p') ;;
		esac
		mapfile -t COMPREPLY < <(compgen -f -- "$word")
	fi
	mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -W "$words" -- "$word")
}
complete -F _scree scree
