// The topics that have subjects of another hand inside the program.
#pragma once

#include "tests/foreign/inside.hpp"

namespace mmverify::tests::foreign {

InsideFaults inside_faults_of_index();
InsideFaults inside_right_of_index();
InsideFaults inside_faults_of_provers();
InsideFaults inside_right_of_provers();
InsideFaults inside_faults_of_micromap();
InsideFaults inside_right_of_micromap();
InsideFaults inside_faults_of_tree();
InsideFaults inside_right_of_tree();
InsideFaults inside_faults_of_vq();
InsideFaults inside_right_of_vq();

struct InsideTopic {
  InsideFaults (*faults)();
  InsideFaults (*right)();
};

/// One row a source.
inline constexpr InsideTopic inside_topics[] = {
    {inside_faults_of_index, inside_right_of_index},
    {inside_faults_of_provers, inside_right_of_provers},
    {inside_faults_of_micromap, inside_right_of_micromap},
    {inside_faults_of_tree, inside_right_of_tree},
    {inside_faults_of_vq, inside_right_of_vq},
};

}  // namespace mmverify::tests::foreign
