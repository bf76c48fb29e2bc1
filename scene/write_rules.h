// SPDX-License-Identifier: MIT
// write_rules.h -- writes the pairs of materials, the excluded pairs of bodies and the fields of a world as those of a scene file.
#ifndef WRITE_RULES_H
#define WRITE_RULES_H
#include "scene/contents.h"

bool write_materials(Contents* contents, Writer* writer);
bool write_exclusions(Contents* contents, Writer* writer);
bool write_fields(Contents* contents, Writer* writer);

#endif
