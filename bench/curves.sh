#!/usr/bin/env bash
# curves.sh -- measures the time of a step for 100 to 10 million bodies, at rest and in a storm.
#
# usage: bench/curves.sh [FOLDER [DEVICE...]]
#   FOLDER  gets curves.csv, curves.svg and curves.png; default bench/results/local
#   DEVICE  as for scree --device; default cpu
# Variables and their defaults: SIZES (100 1k 10k 100k 1M 10M); CPU_SIZES, the sizes on the CPU (SIZES without 10M); SCENES
# (pyramids storm); LIMIT, seconds for one run (600); SCREE, the path of the command line (build/scree).
# bench/plot.sh draws the curves. Exit 1 when a row is invalid or missing.
set -uo pipefail
. "$(dirname "$0")/../tools/usage.sh"
cd "$(dirname "$0")/.." || exit 1
folder=${1:-bench/results/local}
[ $# -gt 0 ] && shift
[ $# -gt 0 ] || set -- cpu
scree=${SCREE:-build/scree}
mkdir -p "$folder"
csv=$folder/curves.csv
known=()
[ -e bench/known.csv ] && [ "${KNOWN:-}" != write ] && known=(--known bench/known.csv)

# Prints the settings for a scene and a size: a pyramid has 55 boxes; a cell of the storm has 364 bodies and a rotor.
settings_of()
{
	case $1.$2 in
	pyramids.100) echo columns=2 rows=1 ;;
	pyramids.1k) echo columns=6 rows=3 ;;
	pyramids.10k) echo columns=14 rows=13 ;;
	pyramids.100k) echo columns=43 rows=42 ;;
	pyramids.1M) echo columns=135 rows=135 ;;
	pyramids.10M) echo columns=427 rows=426 ;;
	storm.100) echo columns=1 rows=1 across=10 ;;
	storm.1k) echo columns=3 rows=1 ;;
	storm.10k) echo columns=9 rows=3 ;;
	storm.100k) echo columns=17 rows=16 ;;
	storm.1M) echo columns=53 rows=52 ;;
	storm.10M) echo columns=166 rows=165 ;;
	*) return 1 ;;
	esac
}

# Prints the options for a size. The storm begins within 30 steps. Larger sizes have fewer steps and repeats, because their times
# vary little and building them takes longer than running them.
steps_of()
{
	case $1 in
	100 | 1k | 10k) echo --steps 500 --repeats 3 ;;
	100k) echo --steps 200 --repeats 3 ;;
	1M) echo --steps 100 --repeats 2 ;;
	*) echo --steps 60 --repeats 1 ;;
	esac
}

failed=0
: >"$csv"
for device in "$@"; do
	sizes=${SIZES:-100 1k 10k 100k 1M 10M}
	[ "$device" = cpu ] && sizes=${CPU_SIZES:-${sizes/10M/}}
	for scene in ${SCENES:-pyramids storm}; do
		for size in $sizes; do
			settings=$(settings_of "$scene" "$size") || { echo "curves.sh: there are no settings for the scene $scene with the size $size" >&2; exit 2; }
			read -ra options <<<"$(steps_of "$size") --set ${settings// / --set }"
			rows=$(timeout "${LIMIT:-600}" "$scree" bench "$scene" --device "$device" "${options[@]}" "${known[@]}") || failed=1
			row=$(sed -n 2p <<<"$rows")
			[ -n "$row" ] || { echo "curves.sh: scree bench printed no row for $scene with the size $size on $device" >&2; failed=1; continue; }
			[ -s "$csv" ] || head -n 1 <<<"$rows" | tee "$csv"
			echo "$row" | tee -a "$csv"
		done
	done
done

bench/plot.sh "$folder" || failed=1
exit $failed
