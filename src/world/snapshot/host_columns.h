// SPDX-License-Identifier: MIT
// host_columns.h -- declares the columns of the structs on the host that a snapshot contains.
#ifndef HOST_COLUMNS_H
#define HOST_COLUMNS_H
#include "world/snapshot/columns.h"

typedef enum // structs that a snapshot contains
{
	HOST_WORLD,
	HOST_PIPELINE,
	HOST_COUNTERS,
	HOST_BODY,
	HOST_COLLIDABLE,
	HOST_ATTRIBUTE_DEF,
	HOST_ATTRIBUTE,
	HOST_JOINT,
	HOST_PATH,
	HOST_FIELD,
	HOST_EXCLUSION,
	HOST_TARGET,
	HOST_VISIT,
	HOST_VISIT_BEGAN,
	HOST_VISIT_ENDED,
	HOST_DEPARTED,
	HOST_TABLES
} HostTable;

typedef struct
{
	ColumnTable table;
	size_t bytes; // size of the struct
} HostColumns;

extern const HostColumns host_columns[HOST_TABLES];

#endif
