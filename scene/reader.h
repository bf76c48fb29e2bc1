// SPDX-License-Identifier: MIT
// reader.h -- reads and checks JSON values; error messages name the location in the file.
#ifndef READER_H
#define READER_H
#include "scene/expression.h"
#include "scree/scree.h"
#include <jansson.h>

#define SENTENCE_SIZE 512

typedef struct // state of reading one file
{
	const char* file;
	char* sentence; // SENTENCE_SIZE characters for an error message
	Scope scope;    // names that expressions may use
	uint64_t seed;
	uint32_t sites; // number of random() calls so far
	bool redraws;   // true: random() varies even without a loop index, for numbers of churn
	// work and memory so far, for which a short file may give a large factor; see reader_work and reader_claim
	int64_t work;
	size_t claimed; // bytes
} Reader;

#define READER_BYTES ((int64_t)64 << 20)    // maximum size of a file; Jansson needs up to 100 times as much memory
#define READER_WORK  ((int64_t)10000000000) // maximum of Reader.work; evaluating needs 1 to 5 ns for each
#define READER_CLAIM ((size_t)256 << 20)    // maximum of Reader.claimed

// Maximum of Reader.work of the files that are loaded from now on; READER_WORK at first. Fuzz targets lower it.
extern int64_t reader_most_work;

// Location of a value in the file, linked to the location of its parent. Example: attributes . crate . polygon [2].
typedef struct Location
{
	const struct Location* up; // location of the parent; null at the top
	const char* key;           // name of a member; null for an element of a list
	int index;
} Location;
#define KEY(up, key)       (&(Location){(up), (key), 0})
#define ELEMENT(up, index) (&(Location){(up), NULL, (index)})

typedef struct
{
	double low, high;
	bool whole;   // only whole numbers are valid
	bool floored; // only the whole part of the number is used
} Range;

static const Range any_coordinate = {-SCREE_MAX_COORDINATE, SCREE_MAX_COORDINATE, false, false};
static const Range any_constant = {-1e15, 1e15, false, false};

typedef struct // a number that may differ between items
{
	double constant;
	Expression* code; // null for a constant
	char* text;       // text of the expression
	char* path;       // location of the expression, for errors; text and path are null for a constant
	Range range;
} Number;

#if defined(__GNUC__)
#define READER_FORMAT(a, b) __attribute__((format(printf, a, b)))
#else
#define READER_FORMAT(a, b)
#endif

// Returns the JSON of a file, which the caller releases. On failure it writes an error message (SENTENCE_SIZE
// characters) and returns null.
json_t* reader_load(const char* path, char* sentence);

// Likewise, from the text of a file. name: of the file, for messages.
json_t* reader_parse(const void* text, size_t size, const char* name, char* sentence);

// Writes the error message "FILE: PLACE: ..." and returns false.
bool reader_fail(Reader* reader, const Location* location, const char* format, ...) READER_FORMAT(3, 4);

// Writes an error message with the value, shortened, and with the text `must` ("must be ..."). Returns false.
bool reader_fail_value(Reader* reader, const Location* location, const json_t* value, const char* must);

// Counts operations: items, rounds of loops, instructions of expressions, names that are compared. Fails if a file needs
// more than reader_most_work of them.
bool reader_work(Reader* reader, const Location* location, int64_t operations);
// Counts bytes of the collidables of blocks and of expressions, which a repeat may multiply. Fails at READER_CLAIM.
bool reader_claim(Reader* reader, const Location* location, size_t bytes);

// Returns null if a value is inside a range; otherwise the reason, "must be ...", which may lie in `text`.
const char* range_fault(Range range, double value, char* text, size_t size);

// Writes a location as "bodies[3].position[0]".
void location_text(const Location* location, char* text, size_t size);

// Returns true if a value is a list, or null: the file does not have it. Otherwise writes an error message.
bool reader_list(Reader* reader, const Location* location, const json_t* value);

// Read one value each. Numbers may be JSON numbers or strings with expressions.
bool reader_number(Reader* reader, const Location* location, const json_t* value, Range range, Number* number);
bool reader_constant(Reader* reader, const Location* location, const json_t* value, Range range, double* constant);
bool reader_vec(Reader* reader, const Location* location, const json_t* value, Range range, scree_vec* vec);
bool reader_string(Reader* reader, const Location* location, const json_t* value, const char** string);
bool reader_boolean(Reader* reader, const Location* location, const json_t* value,
                    bool* boolean); // stays unchanged if `value` is null

// reader_name reads a name and returns its position in a list that ends with null. reader_names reads a list of such
// names and returns a bit for each.
bool reader_name(Reader* reader, const Location* location, const json_t* value, const char* const* names,
                 uint32_t* position);
bool reader_names(Reader* reader, const Location* location, const json_t* value, const char* const* names,
                  uint32_t* bits);

// Reads a word of 64 bits: a whole number, or a text of 0x and hexadecimal digits for numbers that other programs round.
bool reader_user(Reader* reader, const Location* location, const json_t* value, uint64_t* user);

// Reads a list of numbers of bits; a JSON number could not contain all 64 bits.
bool reader_bits(Reader* reader, const Location* location, const json_t* value, uint64_t* bits);

// Read a member of an object. reader_member reads a number; without the member the number is `missing`. reader_pair
// reads a list of two numbers, which must be there.
bool reader_member(Reader* reader, const Location* location, const json_t* object, const char* key, Range range,
                   double missing, Number* number);
bool reader_pair(Reader* reader, const Location* location, const json_t* object, const char* key, Range range,
                 Number pair[2]);

void number_free(Number* number);

#endif
