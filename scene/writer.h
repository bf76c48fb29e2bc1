// SPDX-License-Identifier: MIT
// writer.h -- writes the members of structs as the keys of scene/format.def, those that differ from a default.
#ifndef WRITER_H
#define WRITER_H
#include "scene/format.h"
#include "scene/text.h"

typedef struct
{
	Reader reader; // file and sentence, for errors
	Text text;
	scree_status status; // status of a failure; Reader.sentence is empty if the sentence is that of scree_error
} Writer;

// Writes all keys of an object that need no special code and whose members differ from those of `base`, or that the object must have.
// item, base: structs of the object. Fails if a number is out of the range of its key.
bool writer_object(Writer* writer, const Location* location, FormatObject object, const void* item, const void* base);

// Writes a member with two numbers.
bool writer_vec(Writer* writer, const Location* location, const char* key, scree_vec v, Range range);

// Writes a rotation as the member "angle", if an angle gives its bits, or else as "rotation".
bool writer_rotation(Writer* writer, const Location* location, scree_rot rotation);

// Returns true if the status is SCREE_OK, and notes a failure of the library otherwise.
bool writer_try(Writer* writer, scree_status status);

// Notes that memory is short, and returns false.
bool writer_short(Writer* writer);

#endif
