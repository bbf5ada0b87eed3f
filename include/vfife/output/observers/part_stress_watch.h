// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_output_observers_part_stress_watch_h
#define vfife_output_observers_part_stress_watch_h

#include <vfife/element/frame_kind.h>
#include <vfife/element/stiffness.h>
#include <vfife/model/observer.h>
#include <vfife/output/files/figures.h>

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace vfife
{
  class Log;
  class OutputFolder;
  struct Model;

  /** The largest nodal stress of each part of gear bodies, and where it is: of the faces of a web,
   * of the rim without the fillets of the teeth, of the hub. */
  class PartStresses
  {
  public:
    /** Parts of all bodies that have their node sets. The model must outlive the object. */
    explicit PartStresses(const Model &model);

    /** Looks at von Mises stresses by node of the model [MPa]. */
    void look(const std::function<double(unsigned int node)> &von_mises);

    /** Of each part stress [MPa], and radius from the axis of its body and height along it in the
     * body frame [mm]. */
    NamedFigures list_figures() const;
    void         write_to(Log &log) const;

    /** For checkpoints. */
    void serialize(ByteStream &stream);

  private:
    struct Part
    {
      std::string               name; ///< "gear web"
      unsigned int              body = 0;
      std::vector<unsigned int> nodes; ///< of the body
    };
    /** Of a part so far; the node is one of the body. */
    struct Largest
    {
      double       stress = 0;
      unsigned int node   = 0;
    };
    /** Radius and height of a part's largest stress [mm]. */
    std::pair<double, double> place_of(std::size_t part) const;

    const Model         &model_;
    std::vector<Part>    parts_;
    std::vector<Largest> largest_; ///< by part
  };

  /** The same over a run, by the stresses of all elements every so many steps. */
  class PartStressWatch : public Observer
  {
  public:
    /** Every @p steps_between steps of a run with this stiffness and frame. */
    PartStressWatch(const OutputFolder &folder,
                    const Model        &model,
                    std::uint64_t       steps_between,
                    StiffnessKind       stiffness,
                    FrameKind           frame);

    bool        due(const State &state) const override;
    void        observe(const Model &model, const State &state) override;
    std::string part_name() const override;
    void        serialize(ByteStream &stream) override;

    const PartStresses &stresses() const
    {
      return stresses_;
    }

  private:
    const OutputFolder &folder_;
    std::uint64_t       steps_between_;
    StiffnessKind       stiffness_;
    FrameKind           frame_;
    PartStresses        stresses_;
  };
} // namespace vfife

#endif
