#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# test_mpi.sh -- runs a batch over 1, 2, 3 and 4 ranks of MPI, with the same results; calls that fail on one rank fail on all.
set -uo pipefail
program=${SCREE_BUILD:?is the build folder}/tests/mpi_worlds

skip()
{
	echo "skipped: $*"
	[[ " ${SCREE_EXPECT:-} " == *" mpi "* ]] && exit 1
	exit 77
}
[ -x "$program" ] || skip "MPI was not found when this build was configured; Debian has it in libopenmpi-dev"
. "${SCREE_SOURCE:?is the folder of the sources}/tests/mpi_support.sh"
command -v "$mpiexec" >/dev/null || skip "there is no $mpiexec, which starts programs of MPI; Debian has it in openmpi-bin"
scratch=$(mktemp -d "$SCREE_BUILD/mpi.XXXXXX")
trap 'rm -rf "$scratch"' EXIT

failures=0
for ranks in 1 2 3 4; do
	timeout 120 "$mpiexec" -n $ranks "$program" >"$scratch/$ranks" 2>"$scratch/errors" || {
		echo "FAILED: $ranks ranks: exit code $?"
		cat "$scratch/$ranks" "$scratch/errors"
		failures=$((failures + 1))
		continue
	}
	[ "$(wc -l <"$scratch/$ranks")" = 7 ] || { echo "FAILED: $ranks ranks: not seven lines"; failures=$((failures + 1)); }
	diff "$scratch/1" "$scratch/$ranks" || { echo "FAILED: $ranks ranks: other results than one rank"; failures=$((failures + 1)); }
done
cat "$scratch/1"
echo "$failures failures"
[ "$failures" = 0 ]
