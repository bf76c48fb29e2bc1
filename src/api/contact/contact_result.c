// SPDX-License-Identifier: MIT
// contact_result.c -- converts a contact report to the contact that the user reads.
#include "api/contact/contact_result.h"

// Returns the details of a point. It touched if it had an impulse, or no gap at the start of the step.
static scree_contact_detail detail_of(float total_impulse, float approach_speed, float separation)
{
	return (scree_contact_detail){total_impulse, approach_speed, total_impulse > 0.0f || separation <= 0.0f};
}

scree_contact contact_result(const ContactReport* row, bool details)
{
	scree_contact contact = {
	    .normal = {row->normal_x, row->normal_y}, .color = row->color, .count = (int)(row->flags & CONTACT_COUNT)};
	contact.points[0] = (scree_contact_point){
	    {row->point.x, row->point.y}, row->separation1, row->impulse.x, row->impulse.z, (uint32_t)row->feature.x};
	if (details)
		contact.details[0] = detail_of(row->detail.x, row->detail.z, row->separation1);
	if (contact.count < 2)
		return contact;
	contact.points[1] = (scree_contact_point){
	    {row->point.z, row->point.w}, row->separation2, row->impulse.y, row->impulse.w, (uint32_t)row->feature.y};
	if (details)
		contact.details[1] = detail_of(row->detail.y, row->detail.w, row->separation2);
	return contact;
}
