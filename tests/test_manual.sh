#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# test_manual.sh -- compiles the C fragments of docs/manual, so that they follow the header.
#
# The line above a fragment says how, in a comment that readers of the page do not see:
#   <!-- in HEAD -->                the fragment is the body of a function. HEAD is the head of the function, and before it
#                                   may come declarations that the fragment needs:
#                                   <!-- in void beep(float impulse); void frame(scree_world* world) -->
#   <!-- in a file -->              the fragment is a whole file after the includes below
#   <!-- not compiled: REASON -->   the fragment needs what is not here, such as another library
set -euo pipefail
cd "${SCREE_SOURCE:?is the folder of the sources}"
folder=$(mktemp -d "${SCREE_BUILD:?is the build folder}/test_manual.XXXXXX")
trap 'rm -rf "$folder"' EXIT

# writes each fragment to a file of its own; prints the name of each file, or a complaint
awk -v folder="$folder" '
	function begin(where)
	{
		file = FILENAME
		gsub(/^docs\/manual\/|\.md$/, "", file)
		file = folder "/" file "_" where ".c"
		print "#include <scree/scree_math.h>\n#include <scree/scree_scene.h>\n#include <stdio.h>\n#include <stdlib.h>\n#include <string.h>" >file
		print file
	}
	FNR == 1 { if (inside) print "FAILED: a fragment has no end before " FILENAME; inside = 0; mark = "" }
	/^```c$/ && !inside {
		inside = 1
		compiled = mark ~ /^<!-- in .* -->$/
		if (!compiled && mark !~ /^<!-- not compiled: .+ -->$/)
			print "FAILED: " FILENAME ":" FNR ": no line above the fragment says how it is compiled"
		if (!compiled)
			next
		head = substr(mark, 9, length(mark) - 12)
		body = head != "a file"
		begin(FNR)
		if (body)
			print head "\n{" >file
		print "#line " FNR + 1 " \"" FILENAME "\"" >file
		next
	}
	/^```$/ && inside { if (compiled) { if (body) print "}" >file; close(file) } inside = 0; mark = ""; next }
	inside && compiled { print >file }
	!inside { mark = $0 }' docs/manual/*.md >"$folder/list"
failures=$(grep -c '^FAILED' "$folder/list" || true)
grep '^FAILED' "$folder/list" || true

count=0
while read -r file; do
	count=$((count + 1))
	"${CC:-cc}" -std=c17 -Wall -Wextra -Werror -Wno-unused -fsyntax-only -I include "$file" || failures=$((failures + 1))
done < <(grep -v '^FAILED' "$folder/list")
echo "$count fragments"
[ "$count" -ge 30 ] || { echo "FAILED: docs/manual has more fragments than these"; exit 1; }
exit $((failures > 0))
