#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# fuzz.sh -- builds the fuzz targets with libFuzzer and runs each for some seconds, from the seeds of tests/fuzz/seeds.
#
# usage: fuzz.sh [--seconds N] [--again] [TARGET...]
#   --seconds N   time of each target (60)
#   --again       also begins with the inputs that earlier runs have kept in build/fuzz/corpus
#   TARGET        snapshot, recording, scene, api (all of them)
# An input at which a target fails is kept as build/fuzz/TARGET-crash-..., -oom-... or -timeout-...; exit 1. Exit 77 if clang or
# its library libFuzzer is missing.
set -euo pipefail
cd "$(dirname "$0")/../.."

usage() { sed -n '/^# usage/,/^set /p' "$0" | sed -e '$d' -e 's/^# \{0,1\}//'; }

seconds=60
again=
targets=()
while [ $# -gt 0 ]; do
	case $1 in
	--help) usage && exit ;;
	--seconds) seconds=${2:?is missing} && shift ;;
	--again) again=1 ;;
	snapshot | recording | scene | api) targets+=("$1") ;;
	*) echo "fuzz.sh: there is no option or target $1" >&2 && usage >&2 && exit 2 ;;
	esac
	shift
done
[ ${#targets[@]} -gt 0 ] || targets=(snapshot recording scene api)

probe=$(mktemp -d)
trap 'rm -rf "$probe"' EXIT
echo '#include <stddef.h>
int LLVMFuzzerTestOneInput(const unsigned char* bytes, size_t size) { return bytes && size > 9; }' >"$probe/probe.c"
if ! clang -fsanitize=fuzzer,address,undefined "$probe/probe.c" -o "$probe/probe" 2>"$probe/errors"; then
	echo "fuzz.sh: skipped, because clang cannot link libFuzzer; Debian has it in clang and libclang-rt-dev"
	head -3 "$probe/errors"
	exit 77
fi

cmake --preset fuzz --log-level=NOTICE
cmake --build --preset fuzz --target fuzz -- -k 0 >"$probe/build" || { tail -30 "$probe/build"; exit 1; }

# longest input, bytes; larger ones are slow and find no more
declare -A most=([snapshot]=40000 [recording]=40000 [scene]=12000 [api]=1200)
# memory stays with the process; its return to the system has taken more than 20 s on a machine that lacked memory
export ASAN_OPTIONS=handle_abort=1:allocator_release_to_os_interval_ms=-1 UBSAN_OPTIONS=print_stacktrace=1
failed=0
printf '%-10s %10s %8s %10s %8s\n' target seconds inputs per_second edges
for target in "${targets[@]}"; do
	corpus=build/fuzz/corpus/$target
	[ -n "$again" ] || rm -rf "$corpus"
	mkdir -p "$corpus"
	log=build/fuzz/$target.log
	# a single allocation of the library, and the memory of the process, MB; the targets have stricter limits
	if build/fuzz/tests/fuzz_"$target" -max_total_time="$seconds" -timeout=20 -max_len="${most[$target]}" -len_control=0 \
		-malloc_limit_mb=700 -rss_limit_mb=2500 -artifact_prefix="build/fuzz/$target-" -print_final_stats=1 \
		"$corpus" "tests/fuzz/seeds/$target" >"$log" 2>&1; then
		state=
	else
		state=FAILED
		failed=1
	fi
	awk -v target="$target" -v seconds="$seconds" -v state="$state" '
		/cov: / { for (k = 1; k < NF; ++k) if ($k == "cov:") edges = $(k + 1) }
		/number_of_executed_units/ { inputs = $2 }
		END { printf "%-10s %10s %8s %10.0f %8s %s\n", target, seconds, inputs, inputs / seconds, edges, state }' "$log"
	[ -z "$state" ] || grep -vE '^#[0-9]|^INFO|fuzzer::' "$log" | tail -40
done
exit $failed
