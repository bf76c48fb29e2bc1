#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# rename.sh -- changes programs that use Scree to the new names of docs/manual/names.md: C, C++ and JavaScript files, in place.
#
# usage: tools/rename.sh FILE...
#
# Names of functions, types and constants are changed as whole words, and names of members if the struct is known. Other members
# with such names are not changed. For each of them the script prints
#   FILE:LINE: NAME may be NEW instead.
# If a file cannot be read or written, no file is changed. In this case, and if an argument is wrong, the exit code is 2.
set -euo pipefail
. "$(dirname "$0")/usage.sh"
tools=$(cd "$(dirname "$0")" && pwd)
names=$tools/../docs/manual/names.md
program=(-f "$tools/rename.awk" -f "$tools/rename_tokens.awk" -f "$tools/rename_c.awk" -f "$tools/rename_js.awk")
refuse()
{
	echo "rename.sh: $*" >&2
	exit 2
}

# language FILE: prints c or js, by the extension of the file
language()
{
	case $1 in
	*.c | *.h | *.cc | *.cpp | *.cxx | *.c++ | *.C | *.hh | *.hpp | *.hxx | *.h++ | *.H) echo c ;;
	*.inl | *.ipp | *.tpp | *.m | *.mm) echo c ;;
	*.js | *.mjs | *.cjs | *.jsx | *.ts | *.mts | *.cts | *.tsx) echo js ;;
	esac
}

[ $# -gt 0 ] || refuse "names no file; --help lists the arguments"
[ -r "$names" ] || refuse "cannot read the table of names, $names"
for file in "$@"; do
	[[ $file != -* ]] || refuse "unknown option $file; --help lists the arguments"
	[ -e "$file" ] || refuse "there is no file $file"
	[ -f "$file" ] || refuse "$file is not a file"
	[ -r "$file" ] || refuse "cannot read $file"
	[ -w "$file" ] || refuse "cannot write $file"
	[ -n "$(language "$file")" ] || refuse "$file is not called like a file of C, C++ or JavaScript"
	[ "$(tr -d '\000' <"$file" | wc -c)" = "$(wc -c <"$file")" ] || refuse "$file is not text"
done

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
k=0
for file in "$@"; do
	k=$((k + 1))
	: >"$work/$k.report"
	# awk takes an argument with = for a variable, unless a folder precedes it
	path=$([[ $file = /* ]] && echo "$file" || echo "./$file")
	LC_ALL=C awk -v language="$(language "$file")" -v file="$file" -v report="$work/$k.report" \
		-v open_end="$([ -z "$(tail -c 1 "$file")" ] && echo 0 || echo 1)" "${program[@]}" "$names" "$path" >"$work/$k" ||
		refuse "could not read $file"
done

k=0 changed=0
for file in "$@"; do
	k=$((k + 1))
	cat "$work/$k.report"
	cmp -s "$file" "$work/$k" && continue
	lines=$({ diff "$file" "$work/$k" || true; } | grep -c '^>')
	cat "$work/$k" >"$file"
	echo "$file: changed on $lines lines"
	changed=$((changed + 1))
done
echo "rename.sh: changed $changed of $# files; $(cat "$work"/*.report | wc -l) names are left to you"
