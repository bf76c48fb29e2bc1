// SPDX-License-Identifier: MIT
// stage_items.h -- defines each kernel as a function of one item, name_item(p, i). Headers of stages are included after
// this file.
#ifndef STAGE_ITEMS_H
#define STAGE_ITEMS_H
#include "dialect/dialect.h"
#undef KERNEL
#undef LIST_KERNEL
#undef GROUP_KERNEL
#define KERNEL(name)                    INLINE void name##_item(const Pools* p, int i)
#define LIST_KERNEL(name, list, length) INLINE int name##_item(const Pools* p, int i)
#define GROUP_KERNEL(name)              INLINE void name##_group(const Pools* p, int i, LOCAL float* bench)

#endif
