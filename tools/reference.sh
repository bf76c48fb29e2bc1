#!/bin/sh
# reference.sh -- builds the reference of the public interface with Doxygen.
#
# usage: tools/reference.sh SOURCE OUT
#
# Fails if a public function has no comment.
set -eu
. "$(dirname "$0")/usage.sh"
[ $# -eq 2 ] || usage
source=$(cd "$1" && pwd)
mkdir -p "$2"
out=$(cd "$2" && pwd)
sed -e "s#@source@#$source#g" -e "s#@output@#$out#g" "$source/docs/Doxyfile.in" >"$out/Doxyfile"
doxygen "$out/Doxyfile" >"$out/log.txt" 2>&1
if grep -E 'unbalanced|\(function\).* is not documented' "$out/log.txt" | grep -vE '_(is_null|equals|sized)\('; then
	echo "reference.sh: these lines of $out/log.txt are errors" >&2
	exit 1
fi
