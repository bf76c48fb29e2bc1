// SPDX-License-Identifier: MIT
// own_check.h -- checks the own values of a row, which may come from anywhere.
#ifndef OWN_CHECK_H
#define OWN_CHECK_H
#include "batch/own_host.h"
#include "world/snapshot/columns.h"

// Returns the maximum number of attributes that a world of a template has alone, after any inputs.
int own_attributes(const Template* from);

// Fails with SCREE_ERROR_INVALID if a call of the user would refuse a value, or if an attribute has not the values of all of
// its collidables. index: subject of the message.
scree_status own_check(const ChunkIndex* index, const Template* from, Own own);

#endif
