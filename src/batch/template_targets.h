// SPDX-License-Identifier: MIT
// template_targets.h -- reads the pending targets of kinematic bodies of a template.
//
// A set of targets of a template is a mask: bit k is the target of the kinematic body with the k-th lowest index.
#ifndef TEMPLATE_TARGETS_H
#define TEMPLATE_TARGETS_H
#include "world/world.h"

#define MOST_TARGETS 64 // maximum number of pending targets of a template: bits of a mask

typedef struct // pending target of a kinematic body
{
	Command command; // before the step: COMMAND_TARGET, with the index of the body in the world
	uint64_t hash;   // its part of the hash of the world
} TemplateTarget;

typedef struct
{
	TemplateTarget* items; // by rising index of the body
	int count;
} TemplateTargets;

// Reads the targets of a world into memory that the caller releases. function, number: as for template_read.
scree_status targets_read(const scree_world* world, const char* function, int number, TemplateTargets* made);

// Returns the set of all targets.
uint64_t targets_all(const TemplateTargets* from);

// Returns the part of the hash of a world that a set of targets is.
uint64_t targets_hash(const TemplateTargets* from, uint64_t set);

// Finds the targets of a world that was read among those of a template. Returns false if the template lacks one.
bool targets_find(const TemplateTargets* from, const TemplateTargets* read, uint64_t* set);

// Removes the targets that are not in a set from a clone of the world of the template.
void targets_keep(const TemplateTargets* from, uint64_t set, scree_world* clone);

#endif
