// SPDX-License-Identifier: MIT
// call_codec.h -- writes the arguments and the results of a call as bytes, and reads them.
#ifndef CALL_CODEC_H
#define CALL_CODEC_H
#include "world/record/file_lists.h"

// Writes the arguments of a call, and its results if it has been made. values: the address of each argument.
void call_write(ChunkWriter* writer, RecordedCallId call, const void* const* values);

typedef struct // arguments of a call that is read
{
	RecordedCallId call;
	void* values[MOST_RECORDED_ARGUMENTS];   // address of each argument, as its kind has it in C
	void* pointers[MOST_RECORDED_ARGUMENTS]; // arguments that are pointers
	const void*
	    expected[MOST_RECORDED_ARGUMENTS]; // results of the recorded call; null: the caller did not request them
	int count;
	size_t size;
	uint8_t* memory; // items of the arrays, and results
	size_t capacity;
} CallArguments;

// Reads the arguments of a call from a record. The memory of `arguments` is reused. Fails with SCREE_ERROR_INVALID and a
// sentence that names the record if its bytes are not those of a call, and with SCREE_ERROR_OUT_OF_MEMORY.
scree_status call_read(const char* function, const FileLists* lists, const LogRecord* record, CallArguments* arguments);
void arguments_close(CallArguments* arguments);

// Returns the name of a result that differs from that of the recorded call, or null.
const char* results_differ(const CallArguments* arguments);

#endif
