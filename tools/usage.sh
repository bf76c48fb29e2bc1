# SPDX-License-Identifier: MIT
# usage.sh -- is sourced by scripts: for --help, prints the comment at the head of the script and exits; refuses all other options.
for argument in "$@"; do
	case $argument in
	-h | --help)
		sed -n '/^# [a-z]*\.sh -- /,/^[^#]/s/^# \{0,1\}//p' "$0"
		exit 0
		;;
	-*)
		echo "${0##*/}: unknown option $argument; --help lists the arguments" >&2
		exit 2
		;;
	esac
done
