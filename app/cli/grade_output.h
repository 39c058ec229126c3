// The rows of a grading in the forms that people, scripts and courses read.
//
// Table       submission, scene, verdict, likeliest cause, first sentence of the detail: two runs give the same table
// JUnit       a test suite for each submission, a case for each scene
// Gradescope  results.json of one program: a test for each scene, one point each
#pragma once

#include <span>
#include <string>

#include "app/cli/grade.h"

namespace zscope::cli {

std::string gradeTableOf(std::span<const GradeRow> rows);
std::string gradeJsonOf(std::span<const GradeRow> rows);
std::string gradeJunitOf(std::span<const GradeRow> rows);
std::string gradescopeOf(std::span<const GradeRow> rows);

}  // namespace zscope::cli
