// SPDX-License-Identifier: MIT
// changed_recording.c -- changed_recording FILE CALL STEP AT OTHER: writes a recording whose replay differs (change_call.h).
#include "support/change_call.h"
#include "tools/common/whole_file.h"
#include <stdio.h>
#include <stdlib.h>

int main(int count, char** arguments)
{
	FileBytes file;
	if (count != 6 || !whole_file_read(arguments[1], &file))
	{
		fprintf(stderr, "changed_recording: FILE CALL STEP AT OTHER, and FILE must be readable\n");
		return 2;
	}
	Saved saved = {file.bytes, file.size};
	Saved copy = change_call(saved, arguments[2], atoi(arguments[3]), (size_t)atoi(arguments[4]));
	bool written = whole_file_write(arguments[5], copy.bytes, copy.size);
	free(saved.bytes);
	free(copy.bytes);
	return written ? 0 : 1;
}
