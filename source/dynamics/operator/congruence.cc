// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/dynamics/operator/congruence.h>
#include <vfife/model/body.h>

#include <boost/functional/hash.hpp>

#include <array>
#include <cmath>
#include <unordered_map>

namespace vfife
{
  namespace
  {
    using Key = std::array<std::int64_t, 24>;

    struct KeyHash
    {
      std::size_t operator()(const Key &key) const
      {
        return boost::hash_range(key.begin(), key.end());
      }
    };

    /** Node coordinates in the triad of nodes 0, 1, 2 in units of 1e-8 of the element's size, and
     * that unit's exponent; the kind. */
    Key make_key(const HexahedronNodes &x, const ElementKind &kind)
    {
      const Vector3 e1 = (x.col(1) - x.col(0)).normalized();
      const Vector3 e3 = e1.cross(x.col(2) - x.col(0)).normalized();
      Matrix3       triad;
      triad.row(0) = e1;
      triad.row(1) = e3.cross(e1);
      triad.row(2) = e3;

      // A power of two as unit: the size of congruent elements differs by round-off, its exponent
      // does not (but for one that stands at a power of two: the class is split then).
      const int    exponent = std::ilogb(1e-8 * (x.col(7) - x.col(0)).norm());
      const double unit     = std::ldexp(1., exponent);
      // The shift keeps values that are exact in decimal (0, half cells) away from the edges of
      // rounding.
      constexpr double shift = 0.3137;

      // Node 0 is the origin, seven nodes remain: stiffness, masses and frequency do not see where
      // an element lies nor how it is turned.
      Key         key;
      std::size_t n = 0;
      key[n++]      = exponent;
      key[n++]      = kind.material;
      key[n++]      = std::llround(kind.initial_strain * 1e12);
      for (unsigned int i = 1; i < 8; ++i)
        {
          const Vector3 local = triad * (x.col(i) - x.col(0));
          for (unsigned int c = 0; c < 3; ++c)
            key[n++] = std::llround(local[c] / unit + shift);
        }
      return key;
    }
  } // namespace

  CongruenceClasses find_congruence_classes(const Body                       &body,
                                            const std::vector<std::uint32_t> &elements)
  {
    CongruenceClasses                               classes;
    std::unordered_map<Key, std::uint32_t, KeyHash> known;
    classes.class_of.reserve(elements.size());
    for (const std::uint32_t e : elements)
      {
        const auto [entry, is_new] = known.emplace(make_key(body.element_nodes(e), body.kind_of(e)),
                                                   classes.representative.size());
        if (is_new)
          {
            classes.representative.push_back(e);
            classes.size.push_back(0);
          }
        classes.class_of.push_back(entry->second);
        ++classes.size[entry->second];
      }
    return classes;
  }
} // namespace vfife
