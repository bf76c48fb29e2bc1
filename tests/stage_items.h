// SPDX-License-Identifier: MIT
// stage_items.h -- stages as functions of one item, name_item(p, i), for tests to call: include the stages behind it.
#ifndef STAGE_ITEMS_H
#define STAGE_ITEMS_H
#include "dialect/dialect.h"
#undef STAGE
#undef LIST_STAGE
#undef GROUP_STAGE
#define STAGE(name)                    INLINE void name##_item(const Pools* p, int i)
#define LIST_STAGE(name, list, length) INLINE int name##_item(const Pools* p, int i)
#define GROUP_STAGE(name)              INLINE void name##_group(const Pools* p, int i, BENCH float* bench)

#endif
