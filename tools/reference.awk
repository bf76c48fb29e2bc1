# SPDX-License-Identifier: MIT
# reference.awk -- marks the comments of scree.h and scree_math.h for Doxygen: those before a declaration, and those behind a member.
#
# The comment at the start of scree.h becomes the first page. A heading below a line of dashes begins a group. A
# comment holds for all functions that follow it without an empty line in between.
NR == 1 {
	main = FILENAME ~ /scree\.h$/
	print main ? "/// @mainpage" : "/// @file"
	begins = 1
	next
}
begins && /^\/\// { sub(/^\/\/ ?([a-z_]*\.h -- )?/, "/// "); print; next }
begins { begins = 0; if (main) print "/// @file\n/// The public interface." }
/^\/\/ -----/ {
	if (heading) next
	if (groups) print "/// @}"
	heading = 1
	titled = 0
	next
}
heading && !/^\/\// { print "/// @{"; heading = 0 }
heading && !titled {
	sub(/^\/\/ /, "")
	printf "/// @defgroup %s%02d %s\n", main ? "group" : "math", ++groups, $0
	titled = 1
	next
}
heading { sub(/^\/\/ ?/, "/// "); print; next }
/^\/\// {
	sub(/^\/\//, "///")
	comment = fresh ? comment "\n" $0 : $0
	fresh = 1
	print
	next
}
/^[ \t]*$/ { comment = ""; fresh = 0; print; next }
{
	if (trailed && /^\t[ \t]+\/\/ /) sub(/\/\/ /, "///< ") # goes on with the comment of the line above
	else if (/^\t*\/\/ /) { sub(/\/\/ /, "/// "); trailed = 0 }
	else trailed = sub(/ \/\/ /, " ///< ")
	if (!fresh && comment != "" && /^(SCREE_API|SCREE_MATH|static inline)/) print comment
	fresh = 0
	print
}
END { if (groups) print "/// @}" }
