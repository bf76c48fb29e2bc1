// SPDX-License-Identifier: MIT
// picture_difference.c -- difference ONE.png OTHER.png: prints the difference of two pictures of equal size.
//
// Output: the mean difference of all channels, 0 to 255, and the share of pixels in which a channel differs by more
// than 32.
#include <cairo.h>
#include <stdio.h>
#include <stdlib.h>

#define FAR 32

static cairo_surface_t* read_picture(const char* path)
{
	cairo_surface_t* picture = cairo_image_surface_create_from_png(path);
	if (cairo_surface_status(picture) == CAIRO_STATUS_SUCCESS)
		return picture;
	fprintf(stderr, "difference: cannot read %s: %s\n", path, cairo_status_to_string(cairo_surface_status(picture)));
	return NULL;
}

int main(int count, char** arguments)
{
	if (count != 3)
	{
		fprintf(stderr, "difference: names of two pictures are missing\n");
		return 2;
	}
	cairo_surface_t *a = read_picture(arguments[1]), *b = read_picture(arguments[2]);
	if (!a || !b)
		return 2;
	const int width = cairo_image_surface_get_width(a), height = cairo_image_surface_get_height(a);
	if (width != cairo_image_surface_get_width(b) || height != cairo_image_surface_get_height(b))
	{
		fprintf(stderr, "difference: one is %dx%d pixels, the other %dx%d\n", width, height,
		        cairo_image_surface_get_width(b), cairo_image_surface_get_height(b));
		return 1;
	}
	double sum = 0;
	int far = 0;
	for (int y = 0; y < height; ++y)
	{
		const unsigned char* p =
		    cairo_image_surface_get_data(a) + (size_t)y * (size_t)cairo_image_surface_get_stride(a);
		const unsigned char* q =
		    cairo_image_surface_get_data(b) + (size_t)y * (size_t)cairo_image_surface_get_stride(b);
		for (int x = 0; x < width; ++x)
		{
			int most = 0;
			for (int c = 0; c < 3; ++c) // blue, green, red
			{
				int off = abs(p[4 * x + c] - q[4 * x + c]);
				sum += off;
				most = off > most ? off : most;
			}
			far += most > FAR;
		}
	}
	printf("%.3f %.5f\n", sum / (3.0 * width * height), (double)far / ((double)width * height));
	cairo_surface_destroy(a);
	cairo_surface_destroy(b);
	return 0;
}
