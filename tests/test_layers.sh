#!/usr/bin/env bash
# test_layers.sh -- checks the order of the files. Files in src/ include only files of the same folder and of lower
# folders, and no includes form a circle. A function that a header declares is defined in the .c file with the name of
# the header.
set -euo pipefail
cd "$SCREE_SOURCE"

# Folders in order, the lowest first; ARCHITECTURE.md describes them. Folders on one line do not include each other. A
# line may also name single files of a folder: these files are above the other files of the folder.
layers='platform/exact_floats
platform dialect
pools
constraints
stages/geometry
stages/tree
stages/edit
stages/color
stages/rules
stages/broad_phase
stages/narrow_phase
stages/sleep
stages/field
stages/solve/hub stages/solve/chain
stages/solve
stages/finalize
stages/read
stages/save
stages/batch
stages
backend
cpu opencl
opencl/forms
opencl/opencl_backend opencl/kernels
step
world
world/shape
world/objects
world/chain
world/device
world/upload
world/create world/pool_read
world/snapshot
world/save
world/record
world/recovery
world/record/recorder
world/units
batch
api/world api/body api/collidable api/joint api/query api/field
api/contact api/mover
api/draw
api/batch
api/record'

# folders beside the library, which are searched only for circles of includes
beside='cli mpi scene tools validate view'

# folders of src/ whose headers are not checked for definitions: functions of the stages, the constraints, the pools and the dialect
# are in headers, and headers of the backends declare functions of several files
unpaired='^(opencl|stages|constraints|pools|dialect|cpu)/'

# functions that are defined elsewhere, each with the reason
elsewhere='backend/backend.h cpu_open     each device defines its own, in src/cpu/ and src/opencl/
backend/backend.h cpu_devices    the same
backend/backend.h cpu_self_test  src/cpu/self_test.c
backend/backend.h opencl_open    the same; src/world/device/devices.c in a build without OpenCL
backend/backend.h opencl_test    the same
backend/backend.h opencl_devices the same
backend/backend.h opencl_hint  the same'

# Prints "file includes file" for each include, with paths from the root of the tree. Arguments: folders.
includes()
{
	grep -rHoE '^#include "[^"]+"' --include='*.h' --include='*.c' --include='*.cl' --include='*.cpp' "$@" |
		sed -E 's#^([^:]+):\#include "([^"]+)"#\1 \2#'
}

# Reads lines with two files, of which the first includes the second, and prints circles. A file and its header count as
# one file. tsort prints each file of a circle on its own line.
circles()
{
	sed -E 's/\.(c|h|cpp)( |$)/\2/g' | awk '$1 != $2' | sort -u | tsort 2>&1 >/dev/null |
		sed -nE 's/^tsort: ([a-z].*)$/\1 is part of a circle of includes/p'
}

check_layers()
{
	awk -v layers="$layers" '
		BEGIN { rows = split(layers, row, "\n"); for (r = 1; r <= rows; ++r) { n = split(row[r], f, " "); for (k = 1; k <= n; ++k) rank[f[k]] = r } }
		function room(path) { sub(/\.[a-z]+$/, "", path); while (!(path in rank) && sub("/[^/]*$", "", path)); return path }
		{
			from = room($1); to = room($2)
			if (to == "scree") next
			if (!(from in rank)) { print "src/" $1 ": the folder src/" from " has no layer"; next }
			if (!(to in rank)) { print "src/" $1 " includes " $2 ", which is no part of the library"; next }
			if (from != to && rank[to] >= rank[from]) print "src/" $1 " includes " $2 ", which does not lie below it"
		}'
}

# Prints functions that are declared but not defined. A declaration is a line of a header that begins with a type and
# contains "name("; inline functions and typedefs are left out. A definition is such a line of a .c file that contains
# the body of the function or has no semicolon at its end. Headers are read first.
check_definitions()
{
	local files
	files=$(find . -mindepth 2 \( -name '*.h' -o -name '*.c' \) | sed 's#^\./##' | grep -vE "$unpaired" | sort -t . -k 2r)
	# shellcheck disable=SC2086
	awk -v elsewhere="$elsewhere" '
		BEGIN { rows = split(elsewhere, row, "\n"); for (r = 1; r <= rows; ++r) { split(row[r], f, " "); known[f[1], f[2]] = 1 } }
		function stem(path) { sub(/\.[ch]$/, "", path); return path }
		/^[A-Za-z].*[ *][a-z_0-9]+\(/ && !/^(static|typedef|return|extern|INLINE)/ {
			name = $0; sub(/\(.*/, "", name); sub(/.*[ *]/, "", name)
			if (FILENAME ~ /\.h$/) declared[FILENAME SUBSEP name] = 1
			else if ($0 !~ /;$/ || $0 ~ /\{.*\}/) defined[stem(FILENAME), name] = 1
		}
		END {
			for (d in declared)
			{
				split(d, part, SUBSEP)
				if (!((part[1], part[2]) in known) && !((stem(part[1]), part[2]) in defined))
					print "src/" part[1] " declares " part[2] ", which src/" stem(part[1]) ".c does not define"
			}
		}' $files | sort
}

# Prints folders of src/ that are missing in layers.
check_rooms()
{
	find . -mindepth 1 -type d | sed 's#^\./##' | while read -r room; do
		tr ' ' '\n' <<<"$layers" | grep -qx "$room" || [ "$room" = api ] || echo "the folder src/$room has no layer"
	done
}

# Prints files whose names another file also has. A header and its .c file count as one file. Files named main and
# primitives are left out.
check_names()
{
	find src cli scene view bench/peers bench/sleep tools tests -name '*.[ch]' -o -name '*.cpp' | grep -v '/primitives\.' |
		sed -E 's/\.[a-z]+$//' | sort -u | awk -F/ '{ if ($NF in first && $NF != "main") print $0 " has the name of " first[$NF]; first[$NF] = $0 }'
}

# Runs all checks on the tree in the current folder, and prints the errors.
check()
{
	check_names
	(
		cd src
		includes . | sed 's#^\./##' >"$work/includes"
		check_layers <"$work/includes"
		circles <"$work/includes" | sed 's#^#src/#'
		check_definitions
		check_rooms
		find . -maxdepth 1 -type f | sed 's#^\./\(.*\)$#src/\1 lies in no folder#'
	)
	# shellcheck disable=SC2086
	includes $beside | awk '{ folder = $1; sub("/[^/]*$", "", folder); print $1, $2 ~ "/" ? $2 : folder "/" $2 }' | circles
}

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
found=$(check) || true
if [ -n "$found" ]; then
	echo "$found"
	exit 1
fi

# tests that the checks find each kind of error: expect adds a line to a file, and fails unless check prints the
# expected complaint
mkdir "$work/tree"
# shellcheck disable=SC2086
cp -r --parents src $beside bench/peers bench/sleep tests "$work/tree"
cd "$work/tree"
expect()
{
	local file=$1 line=$2 complaint=$3
	cp "$file" "$work/kept"
	echo "$line" >>"$file"
	check >"$work/found" || true # tsort fails when it finds a circle
	cp "$work/kept" "$file"
	grep -q "$complaint" "$work/found" || { echo "not seen: $complaint"; exit 1; }
}
expect src/step/tree_maintenance.c '#include "world/world.h"' 'step/tree_maintenance.c includes world/world.h, which does not lie below it'
expect src/stages/geometry/convex.h '#include "stages/tree/tree.h"' 'convex.h includes stages/tree/tree.h, which does not lie below it'
expect src/step/pipeline_state.h '#include "step/tree_maintenance.h"' 'src/step/tree_maintenance is part of a circle'
expect src/world/memory.c '#include "world/upload/upload.h"' 'src/world/memory is part of a circle'
expect src/world/objects/handles.h 'void world_missing(void);' 'handles.h declares world_missing, which src/world/objects/handles.c does not define'
expect src/world/objects/handles.h 'scree_status world_upload(scree_world* world);' 'handles.h declares world_upload, which'
expect cli/common/options.h '#include "csv.h"' '^cli/common/options is part of a circle'

# misplace moves a file to a wrong folder and changes its path in all includes; it fails unless check prints the
# expected complaint
misplace()
{
	local file=$1 room=$2 complaint=$3
	mv "$file" "$room"
	{ grep -rlF "\"${file#src/}\"" src || true; } | xargs -r sed -i "s#\"${file#src/}\"#\"${room#src/}/${file##*/}\"#"
	check >"$work/found" || true
	grep -q "$complaint" "$work/found" || { echo "not seen: $complaint"; exit 1; }
}
misplace src/stages/geometry/manifold.h src/stages/finalize 'geometry/sweep.h includes stages/finalize/manifold.h, which does not'
misplace src/world/objects/mass.c src/world/shape 'objects/mass.h declares mass_'
mkdir src/stages/more
touch view/manifold.h
check >"$work/found" || true
for complaint in 'the folder src/stages/more has no layer' 'view/manifold has the name of src/stages/finalize/manifold'; do
	grep -qx "$complaint" "$work/found" || { echo "not seen: $complaint"; exit 1; }
done
