#!/usr/bin/env bash
# auto.sh -- measures the cost of device "auto": whole runs of 500 steps on the CPU, on the GPU and with auto, for several sizes.
#
# usage: bench/auto.sh SCREE [DEVICE]
#   SCREE   path of the command line, for example build/scree
#   DEVICE  device that is compared with the CPU, as for --device; default opencl
# Each run is a separate process, and the devices take turns. Variables and their defaults: STEPS (500), REPEATS (5), SCENES
# ("pyramids smash"), SIZES ("100 1000 10000 100000"). Prints one row for each scene and size with the medians of ms_wait: the time
# from scree_world_create to the end of the last step, without the creation of the bodies. CSV_ALL names a file for the rows of all
# runs. Exit 1 when hashes differ.
set -euo pipefail
. "$(dirname "$0")/../tools/usage.sh"
cd "$(dirname "$0")/.."
scree=${1:?is the path of the command line}
device=${2:-opencl}
all=${CSV_ALL:-$(mktemp)}
settings_of()
{
	case $1 in
	pyramids-100) echo -s columns=1 -s rows=1 -s base=13 ;;
	pyramids-1000) echo -s columns=5 -s rows=4 -s base=9 ;;
	pyramids-10000) echo -s columns=14 -s rows=13 ;;
	pyramids-30000) echo -s columns=24 -s rows=23 ;;
	pyramids-100000) echo -s columns=43 -s rows=42 ;;
	smash-100) echo -s columns=12 -s rows=8 ;;
	smash-1000) echo -s columns=40 -s rows=25 ;;
	smash-10000) echo -s columns=125 -s rows=80 ;;
	smash-30000) echo -s columns=220 -s rows=136 ;;
	smash-100000) echo -s columns=400 -s rows=250 ;;
	*) echo "auto.sh: there are no settings for $1" >&2; return 1 ;;
	esac
}

"$scree" hash pyramid --steps 1 --device "$device" >/dev/null # the program is in the cache from now on
echo "scene,device,device_at_end,bodies,steps,ms_open,ms_build,ms_steps,ms_wait,penetration,hash" >"$all"
for scene in ${SCENES:-pyramids smash}; do
	for size in ${SIZES:-100 1000 10000 100000}; do
		for ((k = 0; k < ${REPEATS:-5}; ++k)); do
			for d in cpu "$device" auto; do
				# shellcheck disable=SC2046
				timeout 300 "$scree" bench "$scene" $(settings_of "$scene-$size") --whole --repeats 1 --device "$d" \
					--steps "${STEPS:-500}" | tail -n 1 >>"$all"
			done
		done
	done
done

echo "scene,bodies,steps,cpu_ms,other_ms,auto_ms,auto_steps_ms,auto_at_end,ratio_to_better,penetration,hash,equal"
awk -F, '
function median(name, count,    i, j, x)
{
	for (i = 2; i <= count; ++i)
		for (j = i; j > 1 && value[name, j - 1] > value[name, j]; --j)
		{
			x = value[name, j]; value[name, j] = value[name, j - 1]; value[name, j - 1] = x
		}
	return count % 2 ? value[name, (count + 1) / 2] : (value[name, count / 2] + value[name, count / 2 + 1]) / 2
}
NR > 1 {
	key = $1 "," $4 "," $5
	if (!(key in hash)) { keys[++kinds] = key; hash[key] = $11; depth[key] = $10; equal[key] = "yes" }
	if (hash[key] != $11) { equal[key] = "no"; bad = 1 }
	kind = $2 == "cpu" || $2 == "auto" ? $2 : "other"
	n = ++runs[key, kind]
	value[key SUBSEP kind, n] = $9
	if (kind == "auto") { value[key SUBSEP "steps", n] = $8; end[key] = $3; sub(/:.*/, "", end[key]) }
}
END {
	for (k = 1; k <= kinds; ++k)
	{
		key = keys[k]
		cpu = median(key SUBSEP "cpu", runs[key, "cpu"])
		other = median(key SUBSEP "other", runs[key, "other"])
		own = median(key SUBSEP "auto", runs[key, "auto"])
		steps = median(key SUBSEP "steps", runs[key, "auto"])
		better = cpu < other ? cpu : other
		printf "%s,%.1f,%.1f,%.1f,%.1f,%s,%.3f,%s,%s,%s\n", key, cpu, other, own, steps, end[key], own / better,
			depth[key], hash[key], equal[key]
	}
	exit bad
}' "$all"
