// SPDX-License-Identifier: MIT
// The page of a report: an HTML file with its script in it, to which the data of one report are added.
#ifndef TOOL_REPORT_PAGE_H
#define TOOL_REPORT_PAGE_H

#include "tool.h"

/// What is put into a page. Texts are hostile: they name what files name.
typedef struct toolReportData
{
	const char* json;
	const uint8_t* character; // a .glb
	size_t characterCount;
	const uint8_t* ground; // likewise
	size_t groundCount;
} toolReportData;

/// The template's text, which free() ends.
/// @param path NULL: the one that was installed with the program
bool toolReadReportTemplate( const char* path, char** page, toolError* error );

/// The whole page, which free() ends.
/// @param page as toolReadReportTemplate() gives it
char* toolFillReport( const char* page, const toolReportData* data, size_t* byteCount );

#endif
