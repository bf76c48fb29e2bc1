# SPDX-License-Identifier: MIT
# reference.awk -- marks the comments of scree.h for Doxygen: those before a declaration, and those behind a member.
#
# The comment at the start of the file becomes the first page. A heading below a line of dashes begins a group. A
# comment holds for all functions that follow it without an empty line in between.
NR == 1 { print "/// @mainpage"; begins = 1; next }
begins && /^\/\// { sub(/^\/\/ ?(scree\.h -- )?/, "/// "); print; next }
begins { begins = 0; print "/// @file"; print "/// The public interface." }
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
	printf "/// @defgroup group%02d %s\n", ++groups, $0
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
	if (!fresh && comment != "" && /^(SCREE_API|static inline)/) print comment
	fresh = 0
	print
}
END { if (groups) print "/// @}" }
