#!/usr/bin/env bash
# test_layers.sh -- the floor plan: each folder of src/ includes only itself and what lies below it, and no includes form a circle.
set -euo pipefail
cd "$SCREE_SOURCE"

# from the ground up; ARCHITECTURE.md says what is where. Folders of one line do not know each other.
layers='platform dialect
pools
constraints
stages
backend
cpu opencl
device
step
world
api'

check()
{
	local src=$1
	# "file includes file", both from $src on
	(cd "$src" && grep -rHoE '^#include "[^"]+"' --include='*.h' --include='*.c' --include='*.cl' . |
		sed -E 's#^\./([^:]+):\#include "([^"]+)"#\1 \2#') >"$work/includes"
	awk -v layers="$layers" '
		BEGIN { rows = split(layers, row, "\n"); for (r = 1; r <= rows; ++r) { n = split(row[r], f, " "); for (k = 1; k <= n; ++k) rank[f[k]] = r } }
		function folder(path) { sub("/.*", "", path); return path }
		{
			from = folder($1); to = folder($2)
			if (to == "scree") next
			if (!(from in rank)) { print "src/" $1 ": the folder src/" from " has no layer"; next }
			if (!(to in rank)) { print "src/" $1 " includes " $2 ", which is no part of the library"; next }
			if (from != to && rank[to] >= rank[from]) print "src/" $1 " includes " $2 ", which does not lie below it"
		}' "$work/includes"
	# tsort names the files of a circle, two a line
	tsort "$work/includes" 2>&1 >/dev/null | sed -n 's/^tsort: \([a-z].*\.[a-z]*\)$/src\/\1 is part of a circle of includes/p'
	find "$src" -maxdepth 1 -type f | sed 's/$/ lies in no folder/'
}

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
found=$(check src)
if [ -n "$found" ]; then
	echo "$found"
	exit 1
fi

# the check sees what it is for: one include the wrong way round, and a circle
cp -r src "$work/src"
echo '#include "world/world.h"' >>"$work/src/step/tree.c"
check "$work/src" | grep -q 'step/tree.c includes world/world.h, which does not lie below it' || { echo "an upward include is not seen"; exit 1; }
cp src/step/tree.c "$work/src/step/tree.c"
echo '#include "step/tree.h"' >>"$work/src/step/pipeline.h"
check "$work/src" | grep -q 'step/pipeline.h is part of a circle' || { echo "a circle is not seen"; exit 1; }
