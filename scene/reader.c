// SPDX-License-Identifier: MIT
// reader.c -- reads and checks JSON values; errors name the location in the file.
#include "scene/reader.h"
#include "tools/common/open_input.h"
#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define SHOWN 48 // maximum number of characters of an invalid value in an error message

int64_t reader_most_work = READER_WORK;

typedef struct // file or text that Jansson reads
{
	FILE* file;       // null: a text
	const char* text; // part of the text that is left
	size_t left;      // bytes of that part
	bool begun;       // true after the first part
	int fault;        // errno of a failure; 0: none
	int64_t size;     // bytes so far
} Source;

// Reads the next part of a file, without the byte order mark that some editors write at the start of a text.
static size_t read_part(void* buffer, size_t size, void* context)
{
	Source* source = context;
	size_t count = fread(buffer, 1, size, source->file);
	if (ferror(source->file))
		source->fault = errno;
	source->size += (int64_t)count;
	if (source->size > READER_BYTES)
		return (size_t)-1;
	if (!source->begun && count >= 3 && memcmp(buffer, "\xef\xbb\xbf", 3) == 0)
		memmove(buffer, (char*)buffer + 3, count -= 3);
	source->begun = true;
	return count;
}

// Reads the next part of a text in memory, without the byte order mark.
static size_t read_text(void* buffer, size_t size, void* context)
{
	Source* source = context;
	if (!source->begun && source->left >= 3 && memcmp(source->text, "\xef\xbb\xbf", 3) == 0)
	{
		source->text += 3;
		source->left -= 3;
	}
	source->begun = true;
	size_t count = size < source->left ? size : source->left;
	memcpy(buffer, source->text, count);
	source->text += count;
	source->left -= count;
	return count;
}

// Reads a source to its end. name: of the file, for messages. On failure writes an error message and returns null.
static json_t* read_source(Source* source, json_load_callback_t read, const char* name, char* sentence)
{
	json_error_t error = {.line = 0};
	json_t* root = NULL;
	if (source->fault == 0 && source->size <= READER_BYTES)
		root = json_load_callback(read, source, JSON_REJECT_DUPLICATES, &error);
	if (root && source->fault == 0 && source->size <= READER_BYTES)
		return root;
	json_decref(root);
	// one message of Jansson ends with the name of a flag of its C function
	char* flag = strstr(error.text, " without JSON_");
	if (flag)
		*flag = 0;
	if (source->size > READER_BYTES)
		snprintf(sentence, SENTENCE_SIZE, "%.200s: has more than %lld bytes", name, (long long)READER_BYTES);
	else if (source->fault != 0)
		snprintf(sentence, SENTENCE_SIZE, "%.200s: %.200s", name,
		         source->fault == EISDIR ? "is a folder" : strerror(source->fault));
	else if (error.line > 0)
		snprintf(sentence, SENTENCE_SIZE, "%.200s: line %d, column %d: %.200s", name, error.line, error.column,
		         error.text);
	else
		snprintf(sentence, SENTENCE_SIZE, "%.200s: out of memory", name);
	return NULL;
}

json_t* reader_load(const char* path, char* sentence)
{
	Source source = {.file = open_input(path)};
	source.fault = source.file ? 0 : errno;
	json_t* root = read_source(&source, read_part, path, sentence);
	if (source.file)
		fclose(source.file);
	return root;
}

json_t* reader_parse(const void* text, size_t size, const char* name, char* sentence)
{
	Source source = {.text = text, .left = size, .size = (int64_t)size};
	return read_source(&source, read_text, name, sentence);
}

void location_text(const Location* location, char* text, size_t size)
{
	text[0] = 0;
	if (!location)
		return;
	location_text(location->up, text, size);
	size_t length = strlen(text);
	if (location->key)
		snprintf(text + length, size - length, "%s%s", length ? "." : "", location->key);
	else
		snprintf(text + length, size - length, "[%d]", location->index);
}

bool reader_fail(Reader* reader, const Location* location, const char* format, ...)
{
	char path[160];
	location_text(location, path, sizeof path);
	int length = snprintf(reader->sentence, SENTENCE_SIZE, "%s: %s%s", reader->file, path, path[0] ? ": " : "");
	if (length >= SENTENCE_SIZE)
		return false;
	va_list arguments;
	va_start(arguments, format);
	vsnprintf(reader->sentence + length, SENTENCE_SIZE - (size_t)length, format, arguments);
	va_end(arguments);
	return false;
}

bool reader_fail_value(Reader* reader, const Location* location, const json_t* value, const char* must)
{
	if (!value)
		return reader_fail(reader, location, "is missing");
	char* text = json_dumps(value, JSON_ENCODE_ANY | JSON_COMPACT | JSON_REAL_PRECISION(9));
	if (!text)
		return reader_fail(reader, location, "out of memory");
	bool cut = strlen(text) > SHOWN;
	reader_fail(reader, location, "%.*s%s %s", SHOWN, text, cut ? "..." : "", must);
	free(text);
	return false;
}

bool reader_work(Reader* reader, const Location* location, int64_t operations)
{
	reader->work += operations;
	return reader->work <= reader_most_work ||
	       reader_fail(reader, location, "more than %lld operations up to here", (long long)reader_most_work);
}

bool reader_claim(Reader* reader, const Location* location, size_t bytes)
{
	reader->claimed += bytes;
	return reader->claimed <= READER_CLAIM ||
	       reader_fail(reader, location, "collidables and expressions need more than %zu bytes up to here",
	                   READER_CLAIM);
}

const char* range_fault(Range range, double value, char* text, size_t size)
{
	if (range.floored)
		value = floor(value);
	if (!isfinite(value))
		snprintf(text, size, "must be finite");
	else if (value < range.low && range.low == 0)
		snprintf(text, size, "must not be negative");
	else if (value <= 0 && range.low > 0 && range.low < 1)
		snprintf(text, size, "must be positive");
	else if (value < range.low)
		snprintf(text, size, "must be at least %.9g", range.low);
	else if (value > range.high)
		snprintf(text, size, "must be at most %.9g", range.high);
	else if (range.whole && value != floor(value))
		snprintf(text, size, "must be a whole number");
	else
		return NULL;
	return text;
}

bool reader_list(Reader* reader, const Location* location, const json_t* value)
{
	return !value || json_is_array(value) || reader_fail_value(reader, location, value, "must be a list, [ ... ]");
}

bool reader_number(Reader* reader, const Location* location, const json_t* value, Range range, Number* number)
{
	char text[160];
	*number = (Number){.range = range};
	if (json_is_number(value))
	{
		number->constant = json_number_value(value);
		const char* fault = range_fault(range, number->constant, text, sizeof text);
		return fault ? reader_fail_value(reader, location, value, fault) : true;
	}
	if (!json_is_string(value))
		return reader_fail_value(reader, location, value, "must be a number, or a string with an expression");

	const char* expression = json_string_value(value);
	if (!reader_work(reader, location, (int64_t)strlen(expression)))
		return false;
	Expression* code = expression_compile(expression, &reader->scope, &reader->sites, text, sizeof text);
	if (!code)
		return reader_fail(reader, location, "\"%.60s\": %s", expression, text);

	// an expression without a loop index has only one value
	bool varies = !expression_is_constant(code, &number->constant);
	bool indexed = reader->redraws;
	for (int k = 0; k < reader->scope.count; ++k)
		indexed = indexed || reader->scope.names[k].slot >= 0;
	const char* fault = NULL;
	if (varies && !indexed)
	{
		Item item = {.seed = reader->seed};
		fault = expression_evaluate(code, &item, &number->constant);
		varies = false;
	}
	if (!varies)
		free(code);
	if (fault)
		return reader_fail(reader, location, "\"%.60s\": %s", expression, fault);
	if (!varies)
	{
		fault = range_fault(range, number->constant, text, sizeof text);
		return fault ? reader_fail(reader, location, "\"%.60s\" is %.9g, %s", expression, number->constant, fault)
		             : true;
	}
	location_text(location, text, sizeof text);
	number->code = code;
	number->text = strdup(expression);
	number->path = strdup(text);
	if (!number->text || !number->path)
		return reader_fail(reader, location, "out of memory");
	return reader_claim(reader, location, expression_bytes(code) + strlen(expression) + strlen(text));
}

bool reader_member(Reader* reader, const Location* location, const json_t* object, const char* key, Range range,
                   double missing, Number* number)
{
	const json_t* value = json_object_get(object, key);
	*number = (Number){.constant = missing, .range = range};
	return !value || reader_number(reader, KEY(location, key), value, range, number);
}

bool reader_pair(Reader* reader, const Location* location, const json_t* object, const char* key, Range range,
                 Number pair[2])
{
	const json_t* value = json_object_get(object, key);
	pair[0] = pair[1] = (Number){.range = range};
	const Location* at = KEY(location, key);
	if (!json_is_array(value) || json_array_size(value) != 2)
		return reader_fail_value(reader, at, value, "must be a list of 2 numbers");
	return reader_number(reader, ELEMENT(at, 0), json_array_get(value, 0), range, &pair[0]) &&
	       reader_number(reader, ELEMENT(at, 1), json_array_get(value, 1), range, &pair[1]);
}

bool reader_constant(Reader* reader, const Location* location, const json_t* value, Range range, double* constant)
{
	Number number;
	bool good = reader_number(reader, location, value, range, &number);
	*constant = number.constant;
	number_free(&number);
	return good;
}

bool reader_vec(Reader* reader, const Location* location, const json_t* value, Range range, scree_vec* vec)
{
	if (!json_is_array(value) || json_array_size(value) != 2)
		return reader_fail_value(reader, location, value, "must be a list of 2 numbers");
	double x, y;
	if (!reader_constant(reader, ELEMENT(location, 0), json_array_get(value, 0), range, &x) ||
	    !reader_constant(reader, ELEMENT(location, 1), json_array_get(value, 1), range, &y))
		return false;
	*vec = (scree_vec){(float)x, (float)y};
	return true;
}

bool reader_string(Reader* reader, const Location* location, const json_t* value, const char** string)
{
	*string = json_string_value(value);
	return *string && **string ? true
	                           : reader_fail_value(reader, location, value, "must be a string that is not empty");
}

bool reader_boolean(Reader* reader, const Location* location, const json_t* value, bool* boolean)
{
	if (!value)
		return true;
	*boolean = json_is_true(value);
	return json_is_boolean(value) || reader_fail_value(reader, location, value, "must be true or false");
}

static void join(const char* begin, const char* const* names, char* text, size_t size)
{
	size_t length = (size_t)snprintf(text, size, "%s ", begin);
	for (int k = 0; names[k] && length < size; ++k)
		length += (size_t)snprintf(text + length, size - length, "%s%s", k > 0 ? ", " : "", names[k]);
}

bool reader_name(Reader* reader, const Location* location, const json_t* value, const char* const* names,
                 uint32_t* position)
{
	char must[160];
	for (uint32_t k = 0; json_is_string(value) && names[k]; ++k)
	{
		if (strcmp(json_string_value(value), names[k]) != 0)
			continue;
		*position = k;
		return true;
	}
	join("must be one of", names, must, sizeof must);
	return value ? reader_fail_value(reader, location, value, must)
	             : reader_fail(reader, location, "is missing, %s", must);
}

bool reader_names(Reader* reader, const Location* location, const json_t* value, const char* const* names,
                  uint32_t* bits)
{
	char must[160];
	uint32_t position = 0;
	*bits = 0;
	for (int k = 0; k < (int)json_array_size(value); ++k)
	{
		if (!reader_name(reader, ELEMENT(location, k), json_array_get(value, (size_t)k), names, &position))
			return false;
		*bits |= (uint32_t)1 << position;
	}
	join("must be a list of", names, must, sizeof must);
	return json_is_array(value) ||
	       (value ? reader_fail_value(reader, location, value, must) : reader_fail(reader, location, "%s", must));
}

bool reader_user(Reader* reader, const Location* location, const json_t* value, uint64_t* user)
{
	const char* text = json_string_value(value);
	size_t digits = text && strncmp(text, "0x", 2) == 0 ? strspn(text + 2, "0123456789abcdefABCDEF") : 0;
	if (digits >= 1 && digits <= 16 && text[2 + digits] == 0)
		*user = strtoull(text, NULL, 16);
	else if (json_is_integer(value) && json_integer_value(value) >= 0)
		*user = (uint64_t)json_integer_value(value);
	else
		return reader_fail_value(reader, location, value,
		                         "must be a whole number from 0, or 0x with 1 to 16 hexadecimal digits as a string");
	return true;
}

bool reader_bits(Reader* reader, const Location* location, const json_t* value, uint64_t* bits)
{
	if (!json_is_array(value))
		return reader_fail_value(reader, location, value, "must be a list of bits, 0 to 63");
	*bits = 0;
	for (int k = 0; k < (int)json_array_size(value); ++k)
	{
		double bit;
		if (!reader_constant(reader, ELEMENT(location, k), json_array_get(value, (size_t)k),
		                     (Range){0, 63, true, false}, &bit))
			return false;
		*bits |= (uint64_t)1 << (int)bit;
	}
	return true;
}

void number_free(Number* number)
{
	free(number->code);
	free(number->text);
	free(number->path);
	*number = (Number){0};
}
