// Tables of VQ beside its rivals, and of maps of three states read as two.
#pragma once

#include "bench/table.hpp"
#include "bench/vq/rivals/rivals.hpp"

namespace mmverify::bench::rivals {

Table codecs_table(const Figures& figures);
Table readings_table(const Figures& figures);

}  // namespace mmverify::bench::rivals
