// SPDX-License-Identifier: MIT
// attributes.h -- keeps the table of attributes, in which equal values share a slot, and ends attributes.
#ifndef ATTRIBUTES_H
#define ATTRIBUTES_H
#include "pools/pools.h"
#include "scree/scree.h"

// Adds a claim to the attribute with the values of `def`, and creates it if there is none. Sets *index to its slot.
// `def` must be canonical: equal values have equal bytes.
scree_status attribute_claim(scree_world* world, const char* function, const scree_attribute_def* def, int* index);

// Removes one claim of an attribute. Removing the last one frees the slot; no collidable may use the attribute then.
void attribute_disclaim(scree_world* world, int index);

// Finds the attribute without claims that has the values of `def`, a canonical definition, or makes it. Sets *index to its
// slot. The attribute belongs to the collidables that use it, and ends with the last of them.
scree_status attribute_own(scree_world* world, const char* function, const scree_attribute_def* def, int* index);

// Makes an attribute without claims in slot `index`, which is free. No attribute without claims has the values of `def`.
scree_status attribute_put(scree_world* world, const char* function, const scree_attribute_def* def, int index);

// Add and remove one collidable that uses an attribute. Removing the last one ends an attribute without claims.
void attribute_attach(scree_world* world, int index);
void attribute_detach(scree_world* world, int index);

// Ends an attribute that has neither claims nor collidables; no effect otherwise.
void attribute_settle(scree_world* world, int index);

// Makes the table of restored attributes. Equal attributes, both with claims or both without, must have one slot.
scree_status attributes_restore(scree_world* world, const char* function);

// Return the rows of an attribute in the pools attribute, rule and thickness. The thickness of a shape, m, is its
// radius, plus the distance from the centroid to the nearest side if the shape is a polygon.
void attribute_item(const scree_world* world, int index, Attribute* item);
Rule attribute_rule(const scree_world* world, int index);
float attribute_thickness(const scree_world* world, int index);

#endif
