#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# test_unit_constants.sh -- compares src/world/units/constants.def with the source: values are equal, no constant whose comment begins with a
# unit of length is missing, and no call of the library for itself is converted to the unit of a world.
set -euo pipefail
cd "$SCREE_SOURCE"
list=src/world/units/constants.def

# Prints "name value" of each macro whose value is a number, or a product of numbers and such macros.
values()
{
	grep -rhE '^#define [A-Z_]+ +\(?[-A-Z0-9_.e+f* ]+\)?( *//.*)?$' src include --include='*.h' --include='*.c' | sed -E 's# *//.*##; s/[()]//g' |
		awk '{ name = $2; $1 = $2 = ""; text[name] = $0 }
			function value(name, n, parts, k, product)
			{
				n = split(text[name], parts, "*")
				product = 1
				for (k = 1; k <= n; ++k)
				{
					gsub(/ /, "", parts[k])
					if (parts[k] in text) product *= value(parts[k])
					else if (parts[k] ~ /^-?[0-9.]+(e[-+]?[0-9]+)?f?$/) { sub(/f$/, "", parts[k]); product *= parts[k] }
					else return 0
				}
				return product
			}
			END { for (name in text) printf "%s %.9g\n", name, value(name) }'
}

values | sort >"$SCREE_BUILD/units.values"
sed -nE 's/^CONSTANT\(([A-Z_]+), ([-0-9.e]+)f?,.*/\1 \2/p' $list | awk '{ printf "%s %.9g\n", $1, $2 }' | sort >"$SCREE_BUILD/units.listed"
wrong=$(comm -13 "$SCREE_BUILD/units.values" "$SCREE_BUILD/units.listed")
[ -z "$wrong" ] || { echo "$list: other values than in the source, or unknown names: $wrong"; exit 1; }

# a unit of length at the beginning of the comment of a macro, behind it or on a line above it
grep -rnE -B3 '^#define [A-Z_]+ ' src --include='*.h' --include='*.c' |
	awk '{ sub(/^[^ ]*[-:][0-9]+[-:]/, "") } /^\/\/ (m|m\/s|m\^2|m\/s\^2|kg\/m\^2|kg m\^2|m per step)[:,]/ { above = 1; next }
		/^\/\// { next }
		/^#define/ { if (above || $0 ~ /\/\/ (m|m\/s|m\^2|m\/s\^2|kg\/m\^2|kg m\^2|m per step)([:,]|$)/) print $2; above = 0; next } { above = 0 }' |
	sort -u >"$SCREE_BUILD/units.names"
missing=$(comm -23 "$SCREE_BUILD/units.names" <(cut -d' ' -f1 "$SCREE_BUILD/units.listed" | sort))
[ -z "$missing" ] || { echo "$list lacks: $missing"; exit 1; }

# a call of a converted function inside src/api/ would be converted twice
calls=$(sed -nE 's/^(CALL|READ|READ_NOTED|READ_SHARED|PLAIN_LENGTHS)\(([a-z_]+), .*(float|scree_vec|scree_pose|scree_velocity|scree_box|scree_mass|scree_shape|_def|scree_ray|scree_probe).*/\2/p' \
	src/world/record/{recorded,reading,plain}_calls.def | sed 's/_sized$//' | paste -sd'|')
inner=$(grep -rnE "[^\"a-z_]scree_($calls)(_sized)?\((world|call->world|made)," src/api src/world --include='*.c' |
	grep -vE '^src/api/world/(sample_worlds|device_test)\.c' || true)
[ -z "$inner" ] || { echo "a call of the library for itself must be an api_ or metric_ function: $inner"; exit 1; }
echo "$(wc -l <"$SCREE_BUILD/units.listed") constants"
