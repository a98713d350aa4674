// The vectors of blocks, trees, graphs and attribute maps, held against the library.
#include <cmath>

#include "impl/attribute/lookup.hpp"
#include "impl/dag/container.hpp"
#include "impl/micromap/micromap.hpp"
#include "impl/tree/container.hpp"
#include "impl/vq/vq.hpp"
#include "tests/vectors/reading.hpp"

namespace vectors_codecs_test {

using namespace mmverify;
using tests::Reading;
using vectors::Bytes;

Bytes packed(const Bytes& codes, std::uint32_t format) {
  std::vector<impl::micromap::State> states;
  for (const std::uint8_t code : codes) states.push_back(impl::micromap::State(code));
  const auto f = impl::micromap::Format(format);
  Bytes bytes(impl::micromap::packed_bytes(states.size(), f));
  impl::micromap::pack(states, f, bytes);
  return bytes;
}

template <class Block>
void expect_blocks(const Reading& blocks, std::uint32_t side) {
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    const Bytes bytes = blocks.part(k, "bytes"), map = blocks.part(k, "map");
    Block block;
    ASSERT_EQ(bytes.size(), block.size());
    std::copy(bytes.begin(), bytes.end(), block.begin());
    ASSERT_EQ(map.size(), side * side);
    const auto whole = impl::vq::decode(block);
    for (std::uint32_t r = 0; r < side * side; ++r) {
      ASSERT_EQ(map[r], static_cast<std::uint8_t>(whole[r])) << k << ' ' << r;
      ASSERT_EQ(map[r], static_cast<std::uint8_t>(impl::vq::region(block, r % side, r / side)));
    }
  }
}

TEST(VectorsCodecs, BlocksAreTheLibrarys) {
  expect_blocks<impl::vq::Block2>(Reading(tests::family("vq"), "vq2"), 16);
  expect_blocks<impl::vq::Block4>(Reading(tests::family("vq"), "vq4"), 32);
}

// A block of zeros but for one vector that is opaque tells which region a lookup was for.
TEST(VectorsCodecs, HitsFallWhereTheLibrarySays) {
  const Reading hits(tests::family("vq"), "hits"), map2(tests::family("vq"), "vq2"),
      map4(tests::family("vq"), "vq4");
  std::size_t asked = 0;
  for (std::size_t k = 0; k < hits.size(); ++k) {
    const auto half = impl::vq::Half(hits(k, "half"));
    const float u = hits.number(k, "u"), v = hits.number(k, "v");
    const std::uint32_t at = hits(k, "x") + hits(k, "side") * hits(k, "y");
    const Reading& blocks = hits(k, "side") == 16 ? map2 : map4;
    for (std::size_t b = 0; b < blocks.size(); ++b, ++asked) {
      const Bytes bytes = blocks.part(b, "bytes");
      impl::vq::Block2 two;
      impl::vq::Block4 four;
      std::copy_n(bytes.begin(), std::min(bytes.size(), two.size()), two.begin());
      std::copy_n(bytes.begin(), std::min(bytes.size(), four.size()), four.begin());
      const auto state =
          hits(k, "side") == 16 ? impl::vq::state_at(two, half, u, v) : impl::vq::state_at(four, half, u, v);
      ASSERT_EQ(static_cast<std::uint8_t>(state), blocks.part(b, "map")[at]) << k << ' ' << hits.about(k);
    }
  }
  EXPECT_GT(asked, 1000u);
}

// The maps themselves show it: each base transform is applied in turn.
TEST(VectorsCodecs, TransformsAreThoseOfTheirBits) {
  const Reading moves(tests::family("vq"), "transforms");
  for (std::size_t k = 0; k < moves.size(); ++k) {
    const std::uint32_t last = moves(k, "side") - 1, t = moves(k, "number");
    std::uint32_t x = moves(k, "x"), y = moves(k, "y");
    if ((t & 1) != 0) {
      std::swap(x, y);
      x = last - x;
    }
    if ((t & 2) != 0) y = last - y;
    if ((t & 4) != 0) x = last - x;
    EXPECT_EQ(moves(k, "to_x"), x);
    EXPECT_EQ(moves(k, "to_y"), y);
  }
  EXPECT_EQ(moves.size(), 8u * (4 + 16));
}

TEST(VectorsCodecs, CodesUseOnePaletteAPart) {
  const Reading codes(tests::family("vq"), "codes");
  for (std::size_t k = 0; k < codes.size(); ++k) {
    const Bytes vector = codes.part(k, "vector");
    const std::uint32_t how = codes(k, "how"), code = codes(k, "code");
    for (std::uint32_t r = 0; r < vector.size(); ++r) {
      std::uint32_t bit = r, palette = how == 0 ? 4 : 16;
      if (how == 2) palette += r % 4 / 2;
      if (how == 3) palette += r / 8;
      if (how == 4) {
        const std::uint32_t mini = 5 * (r % 4 / 2 + 2 * (r / 8));
        bit = mini + r % 2 + 2 * (r / 4 % 2);
        palette = mini + 4;
      }
      const int wanted = (code >> bit & 1) != 0 ? 1 : (code >> palette & 1) != 0 ? 2 : 0;
      EXPECT_EQ(vector[r], wanted) << k << ' ' << r;
    }
  }
}

TEST(VectorsCodecs, ContainersAreTheLibrarys) {
  const Reading trees(tests::family("trees"), "trees");
  for (std::size_t k = 0; k < trees.size(); ++k) {
    const Bytes map = packed(trees.part(k, "states"), trees(k, "format")),
                container = trees.part(k, "container");
    const auto f = impl::tree::Format(trees(k, "format"));
    ASSERT_EQ(impl::tree::write(trees(k, "level"), f, map), container) << k << ' ' << trees.about(k);
    EXPECT_EQ(impl::tree::read(container).map, map);
    const impl::tree::Stream s = impl::tree::encode_stream(trees(k, "level"), f, map);
    EXPECT_EQ(s.nodes, trees(k, "nodes"));
    EXPECT_EQ(s.leaves, trees(k, "leaves"));
    Bytes bytes = s.tree;
    bytes.insert(bytes.end(), s.data.begin(), s.data.end());
    EXPECT_EQ(bytes, trees.part(k, "bytes")) << k;
  }
  const Reading lookups(tests::family("trees"), "lookups");
  for (std::size_t k = 0; k < lookups.size(); ++k) {
    const auto tree = lookups(k, "tree"), index = lookups(k, "index");
    const auto f = impl::tree::Format(trees(tree, "format"));
    const Bytes states = trees.part(tree, "states");
    const impl::tree::Stream s =
        impl::tree::encode_stream(trees(tree, "level"), f, packed(states, trees(tree, "format")));
    EXPECT_EQ(lookups(k, "state"), impl::tree::lookup_stream(trees(tree, "level"), f, s, index));
    EXPECT_EQ(lookups(k, "state"), states[index]);
    EXPECT_LE(lookups(k, "read"), trees(tree, "nodes"));
  }
}

TEST(VectorsCodecs, BrokenContainersAreRefused) {
  const Reading broken(tests::family("trees"), "broken");
  for (std::size_t k = 0; k < broken.size(); ++k)
    EXPECT_FALSE(impl::tree::try_read(broken.part(k, "bytes"))) << k << ' ' << broken.about(k);
  EXPECT_GT(broken.size(), 30u);
}

TEST(VectorsCodecs, GraphsAreTheLibrarys) {
  const Reading graphs(tests::family("trees"), "graphs");
  for (std::size_t k = 0; k < graphs.size(); ++k) {
    impl::dag::Dag dag(impl::dag::Format(graphs(k, "format")));
    const Bytes states = graphs.part(k, "states");
    std::size_t at = 0;
    for (const std::uint32_t level : graphs.word_list(k, "levels")) {
      const std::size_t count = std::size_t{1} << 2 * level;
      const auto first = states.begin() + static_cast<std::ptrdiff_t>(at);
      dag.add(level, packed({first, first + static_cast<std::ptrdiff_t>(count)}, graphs(k, "format")));
      at += count;
    }
    EXPECT_EQ(at, states.size());
    EXPECT_EQ(impl::dag::save(dag), graphs.part(k, "container")) << k << ' ' << graphs.about(k);
    EXPECT_NO_THROW(impl::dag::load(graphs.part(k, "container")));
  }
}

TEST(VectorsCodecs, OrdersAreTheLibrarys) {
  using namespace impl::attribute;
  const Reading vertices(tests::family("attribute"), "vertices"), faces(tests::family("attribute"), "faces");
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    const auto order = VertexOrder(vertices(k, "order"));
    const auto n = vertices(k, "level"), i = vertices(k, "i"), j = vertices(k, "j");
    const auto at = vertex_at(order, vertices(k, "index"), n);
    ASSERT_TRUE(at.i == i && at.j == j) << k;
    ASSERT_EQ(vertex_index(order, i, j, n), vertices(k, "index")) << k;
  }
  for (std::size_t k = 0; k < faces.size(); ++k) {
    const MicroTriangle t{faces(k, "iu"), faces(k, "iv"), faces(k, "upper") != 0};
    const auto order = FaceOrder(faces(k, "order"));
    ASSERT_EQ(face_index(order, t, faces(k, "level")), faces(k, "index")) << k;
    ASSERT_EQ(face_at(order, faces(k, "index"), faces(k, "level")), t) << k;
  }
}

TEST(VectorsCodecs, WeightsAreTheLibrarys) {
  using namespace impl::attribute;
  const Reading hits(tests::family("attribute"), "hits");
  std::size_t exact = 0;
  for (std::size_t k = 0; k < hits.size(); ++k) {
    const auto n = hits(k, "level");
    const Located found = locate(hits.number(k, "u"), hits.number(k, "v"), n);
    ASSERT_EQ(found.at, (MicroTriangle{hits(k, "iu"), hits(k, "iv"), hits(k, "upper") != 0}))
        << k << ' ' << hits.about(k);
    float sum = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const float weight = hits.number(k, "weight" + std::to_string(c));
      sum += weight;
      EXPECT_GE(weight, 0.0f);
      EXPECT_LE(std::abs(found.weights[c] - weight), std::ldexp(1.0f, -24)) << k;
      if (hits.about(k).starts_with("quarters")) {
        EXPECT_EQ(found.weights[c], weight) << k;
        EXPECT_EQ(hits(k, "exact"), 1u);
      }
      EXPECT_EQ(hits(k, "w_minor" + std::to_string(c)), triplet(VertexOrder::w_minor, found.at, n)[c]);
      EXPECT_EQ(hits(k, "u_major" + std::to_string(c)), triplet(VertexOrder::u_major, found.at, n)[c]);
      EXPECT_EQ(hits(k, "bird" + std::to_string(c)), triplet(VertexOrder::bird, found.at, n)[c]);
    }
    EXPECT_NEAR(sum, 1, 1e-6);
    exact += hits(k, "exact");
  }
  EXPECT_GT(exact, 100u);
  EXPECT_LT(exact, hits.size());
}

}  // namespace vectors_codecs_test
