// SPDX-License-Identifier: MIT
// block_fields.h -- writes the fields of the templates of a block.
#ifndef BLOCK_FIELDS_H
#define BLOCK_FIELDS_H
#include "batch/block_state.h"

// Writes the active fields of the templates that worlds of the block have, and sets the flags that they need.
scree_status block_fields(Block* block);

#endif
