// SPDX-License-Identifier: MIT
// reader.h -- reads and checks JSON values; errors name the location in the file.
#ifndef READER_H
#define READER_H
#include "scene/expression.h"
#include "scree/scree.h"
#include <jansson.h>

#define SENTENCE_SIZE 512

typedef struct // one file that is being read
{
	const char* file;
	char* sentence; // SENTENCE_SIZE characters for an error
	Scope scope;    // names that expressions may use
	uint64_t seed;
	uint32_t sites; // number of random() calls so far
	bool redraws;   // true if expressions are evaluated repeatedly, so that random() is not a constant
} Reader;

// Location of a value in the file, linked to the location of its parent: attributes . crate . polygon [2].
typedef struct Location
{
	const struct Location* up; // null at the top
	const char* key;           // null for an element of a list
	int index;
} Location;
#define KEY(up, key)       (&(Location){(up), (key), 0})
#define ELEMENT(up, index) (&(Location){(up), NULL, (index)})

typedef struct
{
	double low, high;
	bool whole;   // only whole numbers
	bool floored; // only the whole part is used
} Range;

static const Range any_coordinate = {-SCREE_MAX_COORDINATE, SCREE_MAX_COORDINATE, false, false};

typedef struct // a number that may differ between items
{
	double constant;
	Expression* code; // null for a constant
	char* text;       // text of the expression
	char* path;       // its location, for errors; both are null for a constant
	Range range;
} Number;

#if defined(__GNUC__)
#define READER_FORMAT(a, b) __attribute__((format(printf, a, b)))
#else
#define READER_FORMAT(a, b)
#endif

// Returns the JSON of a file, which the caller releases. On failure it writes a sentence of SENTENCE_SIZE characters
// and returns null.
json_t* reader_load(const char* path, char* sentence);

// Writes "FILE: PLACE: ..." as the sentence and returns false.
bool reader_fail(Reader* reader, const Location* location, const char* format, ...) READER_FORMAT(3, 4);

// Fails with the value, shortened, and "must be ...".
bool reader_fail_value(Reader* reader, const Location* location, const json_t* value, const char* must);

// Returns the reason why a value is outside a range, as "must be ..."; null if it is inside.
const char* range_fault(Range range, double value, char* text, size_t size);

// Writes a location as "bodies[3].position[0]".
void location_text(const Location* location, char* text, size_t size);

// Checks that a value is a list, or missing.
bool reader_list(Reader* reader, const Location* location, const json_t* value);

// Read one value each. Numbers may be JSON numbers or strings with expressions.
bool reader_number(Reader* reader, const Location* location, const json_t* value, Range range, Number* number);
bool reader_constant(Reader* reader, const Location* location, const json_t* value, Range range, double* constant);
bool reader_vec(Reader* reader, const Location* location, const json_t* value, Range range, scree_vec* vec);
bool reader_string(Reader* reader, const Location* location, const json_t* value, const char** string);
bool reader_boolean(Reader* reader, const Location* location, const json_t* value,
                    bool* boolean); // unchanged if there is no value

// Read the position of a name in a list that ends with null, and a list of such names as bits.
bool reader_name(Reader* reader, const Location* location, const json_t* value, const char* const* names,
                 uint32_t* position);
bool reader_names(Reader* reader, const Location* location, const json_t* value, const char* const* names,
                  uint32_t* bits);

// Reads a list of bit numbers, because a JSON number cannot hold 64 bits.
bool reader_bits(Reader* reader, const Location* location, const json_t* value, uint64_t* bits);

// Read a member of an object: a number, which gets the value missing if there is none, or a list of two numbers, which
// are 0 then.
bool reader_member(Reader* reader, const Location* location, const json_t* object, const char* key, Range range,
                   double missing, Number* number);
bool reader_pair(Reader* reader, const Location* location, const json_t* object, const char* key, Range range,
                 Number pair[2]);

void number_free(Number* number);

#endif
