#include "scene/flip/flip.hpp"

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <bit>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <string>

#include "scene/flip/colour.hpp"
#include "scene/flip/rows.hpp"

namespace mmverify::flip {
namespace {

using namespace detail;

/// The rows of one task, which filters `2 radius` more along x.
constexpr std::size_t rows_of_task = 128;

void check(const Picture& picture, const char* which) {
  const auto bad = [which](const std::string& what) {
    throw std::invalid_argument(std::string("flip: the ") + which + ": " + what);
  };
  if (picture.width < 1 || picture.height < 1 || picture.width > longest_side ||
      picture.height > longest_side)
    bad(std::to_string(picture.width) + " x " + std::to_string(picture.height) + " texels; 1 to " +
        std::to_string(longest_side) + " a side are compared");
  if (picture.rgb.size() != std::size_t{3} * picture.width * picture.height)
    bad(std::to_string(picture.rgb.size()) + " bytes for " + std::to_string(picture.width) + " x " +
        std::to_string(picture.height) + " texels of 3");
}

/// The amount that each code value of each channel adds to each opponent channel.
struct OpponentTable {
  float of[3][256][opponents];

  OpponentTable() {
    for (std::size_t channel = 0; channel < 3; ++channel)
      for (std::size_t code = 0; code < 256; ++code) {
        const double light = linear_of_srgb(static_cast<double>(code) / 255);
        const auto part = [&](std::size_t row) { return light * relative_xyz_of_rgb[row][channel]; };
        of[channel][code][opponent_y] = static_cast<float>(part(1));
        of[channel][code][opponent_xy] = static_cast<float>(part(0) - part(1));
        of[channel][code][opponent_yz] = static_cast<float>(part(1) - part(2));
      }
  }
};

/// Both parts of two pictures, channel by channel, with `margin` texels more at both ends of each row.
class Planes {
 public:
  Planes(const Picture& a, const Picture& b, std::size_t margin)
      : margin_(margin),
        stride_((a.width + piece - 1) / piece * piece + 2 * margin),
        height_(a.height),
        values_(new float[std::size_t{parts} * opponents * stride_ * height_]) {
    static const OpponentTable table;
    oneapi::tbb::parallel_for(std::size_t{0}, height_, [&](std::size_t y) {
      const std::size_t at = std::size_t{3} * a.width * y;
      for (std::size_t k = 0; k < opponents; ++k)
        fill(a.rgb.data() + at, b.rgb.data() + at, a.width, table, k, first(middle, k, y),
             first(difference, k, y));
    });
  }

  std::array<const float*, opponents> at(Part part, std::size_t x, std::size_t y) const {
    return {first(part, 0, y) + x, first(part, 1, y) + x, first(part, 2, y) + x};
  }

 private:
  void fill(const std::uint8_t* a, const std::uint8_t* b, std::size_t width, const OpponentTable& table,
            std::size_t k, float* sums, float* differences) const {
    for (std::size_t x = 0; x < width; ++x) {
      float sum = 0, difference = 0;
      for (std::size_t channel = 0; channel < 3; ++channel) {
        const float of_a = table.of[channel][a[3 * x + channel]][k],
                    of_b = table.of[channel][b[3 * x + channel]][k];
        sum += of_a + of_b;
        difference += of_a - of_b;
      }
      sums[x] = sum / 2;
      differences[x] = difference / 2;
    }
    for (float* const row : {sums, differences}) {
      std::fill(row - margin_, row, row[0]);
      std::fill(row + width, row - margin_ + stride_, row[width - 1]);
    }
  }

  float* first(std::size_t part, std::size_t k, std::size_t y) const {
    return values_.get() + ((part * opponents + k) * height_ + y) * stride_ + margin_;
  }

  std::size_t margin_, stride_, height_;
  std::unique_ptr<float[]> values_;
};

/// The rows around the current one, filtered along x.  Their number is a power of 2, and each is written over
/// an older one.
class Ring {
 public:
  Ring(const Filters& filters, const Planes& planes, Part part, std::size_t x, std::size_t radius,
       std::size_t height)
      : filters_(filters),
        planes_(planes),
        part_(part),
        x_(x),
        radius_(radius),
        height_(height),
        size_(std::bit_ceil(2 * radius + 1)),
        rows_(size_ * filtered * piece),
        window_(2 * radius + 1) {}

  Window around(std::size_t y) {
    const std::size_t first = y < radius_ ? 0 : y - radius_, last = std::min(height_ - 1, y + radius_);
    for (next_ = std::max(next_, first); next_ <= last; ++next_)
      filter_along_x(filters_, planes_.at(part_, x_, next_), row(next_));
    for (std::size_t k = 0; k <= 2 * radius_; ++k)
      window_[k] = row(y + k < radius_ ? 0 : std::min(height_ - 1, y + k - radius_));
    return window_.data();
  }

 private:
  float (*row(std::size_t y))[piece] {
    return reinterpret_cast<float(*)[piece]>(rows_.data() + (y & (size_ - 1)) * filtered * piece);
  }

  const Filters& filters_;
  const Planes& planes_;
  Part part_;
  std::size_t x_, radius_, height_, size_, next_ = 0;
  std::vector<float> rows_;
  std::vector<const float (*)[piece]> window_;
};

}  // namespace

double pixels_per_degree(double distance, double pixels_across, double width) {
  return distance * (pixels_across / width) * (std::numbers::pi / 180);
}

std::vector<float> error_map(const Picture& reference, const Picture& test, const Options& options) {
  check(reference, "reference");
  check(test, "test");
  if (reference.width != test.width || reference.height != test.height)
    throw std::invalid_argument("flip: " + std::to_string(reference.width) + " x " +
                                std::to_string(reference.height) + " texels against " +
                                std::to_string(test.width) + " x " + std::to_string(test.height));
  if (!(options.pixels_per_degree >= least_pixels_per_degree &&
        options.pixels_per_degree <= most_pixels_per_degree))
    throw std::invalid_argument("flip: " + std::to_string(options.pixels_per_degree) +
                                " pixels per degree; 1 to 1000 are taken");
  const Filters filters{spatial_filters(options.pixels_per_degree),
                        feature_filters(options.pixels_per_degree)};
  const std::size_t radius = std::max(filters.spatial.radius, filters.feature.radius);
  const std::size_t width = reference.width, height = reference.height;
  const std::size_t across = (width + piece - 1) / piece, down = (height + rows_of_task - 1) / rows_of_task;
  std::vector<float> errors(width * height);
  oneapi::tbb::task_arena arena(options.threads == 0 ? oneapi::tbb::task_arena::automatic
                                                     : static_cast<int>(options.threads));
  arena.execute([&] {
    const Planes planes(reference, test, radius);
    oneapi::tbb::parallel_for(std::size_t{0}, across * down, [&](std::size_t task) {
      const std::size_t x = task % across * piece, begin = task / across * rows_of_task;
      Ring sums(filters, planes, middle, x, radius, height),
          differences(filters, planes, difference, x, radius, height);
      float row[piece];
      for (std::size_t y = begin; y < std::min(height, begin + rows_of_task); ++y) {
        errors_of_piece(filters, {sums.around(y), differences.around(y)}, radius, row);
        std::copy_n(row, std::min(piece, width - x),
                    errors.begin() + static_cast<std::ptrdiff_t>(y * width + x));
      }
    });
  });
  return errors;
}

double mean(std::span<const float> errors) {
  double sum = 0;
  for (const float e : errors) sum += e;
  return errors.empty() ? 0 : sum / static_cast<double>(errors.size());
}

double mean(std::span<const float> errors, std::span<const std::uint8_t> counted) {
  if (counted.size() != errors.size()) throw std::invalid_argument("flip: a mask of another size");
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t k = 0; k < errors.size(); ++k)
    if (counted[k] != 0) sum += errors[k], ++count;
  return count == 0 ? 0 : sum / static_cast<double>(count);
}

}  // namespace mmverify::flip
