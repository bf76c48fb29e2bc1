#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# test_train.sh -- runs examples/train.c: it learns, and prints the lines that docs/manual/batch.md shows, on the CPU and through
# OpenCL.
set -uo pipefail
scree=${SCREE_BINARY:?is the path of the command line}
build=${SCREE_BUILD:?is the build folder}
manual=${SCREE_SOURCE:?is the folder of the sources}/docs/manual/batch.md
scratch=$(mktemp -d "$build/train_test.XXXXXX")
trap 'rm -rf "$scratch"' EXIT
failures=0
fail()
{
	echo "FAILED: $*"
	failures=$((failures + 1))
}

"$build/train" >"$scratch/cpu" || fail "train: exit code $?"
cat "$scratch/cpu"
grep -q '^generation  9: poles stand for 10.00 s of 10 s$' "$scratch/cpu" || fail "the poles fall after the last generation"
while read -r line; do
	grep -qxF -- "$line" "$manual" || fail "docs/manual/batch.md lacks the line: $line"
done < <(sed -n -e '1p' -e '/^generation  [49]:/p' -e '$p' "$scratch/cpu")
if [ -x "$scree" ] && "$scree" devices | grep -q '^opencl'; then
	timeout 400 "$build/train" opencl >"$scratch/opencl" || fail "train opencl: exit code $?"
	diff "$scratch/cpu" "$scratch/opencl" || fail "other results through OpenCL"
else
	echo "without OpenCL"
fi
"$build/train" nowhere 2>"$scratch/errors" && fail "an unknown device has no error"
grep -q 'nowhere' "$scratch/errors" || fail "the error does not name the device"
echo "$failures failures"
[ "$failures" = 0 ]
