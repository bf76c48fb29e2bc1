// SPDX-License-Identifier: MIT
// event.h -- writes the events of a step for the host, in an order that is the same on all devices. No step reads them.
#ifndef EVENT_H
#define EVENT_H
#include "stages/read/contact_report.h"

// Writes the sort key of event i: the slot of its contact, or the pair that parted. argument: EVENT_* of the list.
KERNEL(event_key)
{
	p->key[i] = p->argument == EVENT_TOUCH_ENDED   ? p->touch_ended[i]
	            : p->argument == EVENT_TOUCH_BEGAN ? (Word64)p->touch_began[i]
	            : p->argument == EVENT_APPROVALS   ? (Word64)p->asked[i]
	                                               : (Word64)p->hit[i];
}

// Writes the contact of event i, with its points and impulses, after the sort.
KERNEL(event_list) { contact_report_write(p, (int)p->key[i], i); }

#endif
