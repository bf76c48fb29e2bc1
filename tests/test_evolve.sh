#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# test_evolve.sh -- runs some generations of examples/evolve.c: better gaits, equal results on each device and on 1, 2 and 4 ranks of
# MPI, and a recording with equal hashes.
set -uo pipefail
scree=${SCREE_BINARY:?is the path of the command line}
build=${SCREE_BUILD:?is the build folder}
walker=${SCREE_SOURCE:?is the folder of the sources}/scenes/walker.json
[ -x "$build/evolve" ] || { echo "skipped: the library of scene files was not built"; exit 77; }
. "$SCREE_SOURCE/tests/mpi_support.sh"
scratch=$(mktemp -d "$build/evolve_test.XXXXXX")
trap 'rm -rf "$scratch"' EXIT
cd "$scratch" || exit 1
failures=0
fail()
{
	echo "FAILED: $*"
	failures=$((failures + 1))
}

"$build/evolve" "$walker" cpu 5 >alone || fail "evolve: exit code $?"
cat alone
awk '/^generation/ { last = $6; if (!first) first = $6 } END { exit !(last > first + 0.1) }' alone || fail "the gaits do not get better"
grep -q 'as in the batch' alone || fail "the best gait walks otherwise alone"
if [ -x "$scree" ]; then
	"$scree" replay gait.rec --device cpu --threads 2 --lanes 1 | grep -q 'all equal' || fail "gait.rec is not repeated with equal hashes"
fi
if [ -x "$build/evolve_mpi" ] && command -v "$mpiexec" >/dev/null; then
	for ranks in 1 2 4; do
		timeout 200 "$mpiexec" -n $ranks "$build/evolve_mpi" "$walker" cpu 5 >ranks 2>errors || { fail "$ranks ranks: exit code $?"; cat errors; }
		diff alone ranks || fail "$ranks ranks: other results"
	done
else
	echo "without MPI"
fi
echo "$failures failures"
[ "$failures" = 0 ]
