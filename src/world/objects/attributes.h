// SPDX-License-Identifier: MIT
// attributes.h -- keeps the table of attributes, in which equal values share a slot.
#ifndef ATTRIBUTES_H
#define ATTRIBUTES_H
#include "pools/pools.h"
#include "scree/scree.h"

// Claims the attribute with the values of `def`, and creates it if there is none. Sets *index to its slot. def must be
// canonical: equal values have equal bytes.
scree_status attribute_claim(scree_world* world, const char* function, const scree_attribute_def* def, int* index);

// Removes one claim. The removal of the last claim frees the slot; no collidable may use the attribute then.
void attribute_disclaim(scree_world* world, int index);

// Return the rows of an attribute in the pools attribute, rule and thickness.
void attribute_item(const scree_world* world, int index, Attribute* item);
Rule attribute_rule(const scree_world* world, int index);
float attribute_thickness(const scree_world* world, int index); // m: Returns the thickness of an attribute's shape.

#endif
