// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_output_measures_root_stress_h
#define vfife_output_measures_root_stress_h

#include <vfife/base/text/sample_columns.h>
#include <vfife/model/state.h>
#include <vfife/stress/fillet_options.h>
#include <vfife/stress/surface_stress.h>

#include <cmath>
#include <deque>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace vfife
{
  class ByteStream;
  struct Model;

  /** The fillets of one side of all sectors of a member, and where they are in the model. */
  struct MemberFillet
  {
    unsigned int body;
    Fillet       fillet;
  };

  /** A gauge of a member and the tooth that it is glued to. */
  struct MemberGauge
  {
    std::string  name;
    unsigned int body, tooth;
    Gauge        gauge;
  };

  /** Where strains of a surface come from: displacements, places of nodes, or readings. */
  struct FilletStrains
  {
    /** Of a facet, in the axes of its FacetStrain, without the initial strain of its element. */
    std::function<
      SurfaceTensor(const MemberFillet &, unsigned column, unsigned row, unsigned tooth)>
      facet;
    /** Of the copy of a gauge on a tooth, with initial strains: a gauge is not compensated for
     * temperature. */
    std::function<double(const MemberGauge &, unsigned tooth)> gauge;
    /** Traction along the normal that is left on a facet [MPa]; empty where it is not known. */
    std::function<double(const MemberFillet &, unsigned column, unsigned row, unsigned tooth)>
      traction = nullptr;
  };

  /** From vectors at nodes of the model's bodies (body, node), in the axes of the body frame:
   * small displacements [mm]. */
  FilletStrains strains_of_displacements(const Model                               &model,
                                         std::function<Vector3(unsigned, unsigned)> u);

  /** From the present places of the nodes, in any axes [mm]. */
  FilletStrains strains_of_places(const Model                               &model,
                                  std::function<Vector3(unsigned, unsigned)> places);

  /** The largest of one kind of stress in a tooth's fillet. */
  struct RootExtreme
  {
    double  stress   = 0;               ///< [MPa]
    Vector2 place    = Vector2::Zero(); ///< along the face, up the profile [mm]
    double  traction = 0;               ///< along the normal, left at a tension [MPa]; 0: not known
  };

  /** The fillet of one tooth, or sector, at one instant or position. */
  struct RootStressSample
  {
    std::string  body, fillet;
    unsigned int tooth      = 0;
    double       after_mesh = 0; ///< mesh cycles since the tooth stood where tooth 0 begins
    RootExtreme  tension, compression;
  };

  /** The largest stresses of a member's fillets at roots of teeth, or of its web at the hub, over
   * all that has been seen [MPa]. */
  struct MemberFilletStress
  {
    std::string body;
    bool        at_hub  = false;
    double      tension = 0, compression = 0;
    double      range = 0; ///< largest tension less largest compression of one facet
  };

  /** One gauge, or its copy on another tooth, which it will be after so many mesh cycles. */
  struct GaugeSample
  {
    std::string gauge;
    double      after_mesh = 0;
    double      strain     = 0; ///< [-]
  };

  /** Columns of root_stress.csv and gauges.csv behind the time or position. */
  SampleColumns<RootStressSample> list_root_stress_columns();
  SampleColumns<GaugeSample>      list_gauge_columns();

  /** Columns of fillet_envelope.csv and root_sections.csv. */
  Table make_fillet_envelope_table();
  Table make_root_section_table();

  /**
   * Stresses of fillets and gauges of a gear pair: what there is to be seen at an instant, and the
   * envelope of the fillets over all instants and teeth seen so far. Fillets of webs at the hub are
   * looked at in all sectors, and the one with the largest tension is recorded.
   */
  class RootStress
  {
  public:
    /** The model must have a transmission and outlive the object. Throws InputError for gauges that
     * do not fit. */
    RootStress(const Model &model, const FilletOptions &options);

    const std::deque<MemberFillet> &fillets() const
    {
      return fillets_;
    }
    const std::deque<MemberGauge> &gauges() const
    {
      return gauges_;
    }

    /** Stresses of the recorded teeth, @p meshes mesh cycles after time zero; they count for the
     * envelope. */
    std::vector<RootStressSample>
    measure(double meshes, const std::vector<ToothContact> &teeth, const FilletStrains &strains);

    /** What the gauges show; with @p copies what they do on every tooth, a whole turn of theirs. */
    std::vector<GaugeSample>
    read_gauges(double meshes, bool copies, const FilletStrains &strains) const;

    /** fillet_envelope.csv: a row a facet. */
    Table envelope() const;

    /** root_sections.csv: a row a section along the face, of the facets one above the other. */
    Table sections() const;

    /** Of each member's teeth, driver first, then of their hubs. */
    std::vector<MemberFilletStress> list_members() const;

    /** Passes the envelope. */
    void serialize(ByteStream &stream);
    /** Passes when it came about; without it that is not known. */
    void serialize_passages(ByteStream &stream);

  private:
    /** Of a facet over all instants and teeth [MPa]. */
    struct Range
    {
      double tension = 0, compression = 0;

      double range() const
      {
        return tension - compression;
      }
    };

    /** Where a tooth was when the facet had these [mesh cycles after the mesh]. */
    struct Passage
    {
      double tension = std::nan(""), compression = std::nan("");
    };

    std::vector<unsigned int> recorded_teeth(unsigned int                     body,
                                             const std::vector<ToothContact> &teeth) const;
    unsigned int              count_teeth(unsigned int body) const;
    double           after_mesh(unsigned int body, unsigned int tooth, double meshes) const;
    RootStressSample measure_tooth(std::size_t          fillet,
                                   unsigned int         tooth,
                                   double               meshes,
                                   const FilletStrains &strains);

    const Model                                   &model_;
    RecordedTeeth                                  teeth_;
    std::map<unsigned int, std::set<unsigned int>> named_teeth_; ///< by body
    std::deque<MemberFillet>                       fillets_;     // nothing moves: gauges know them
    std::deque<MemberGauge>                        gauges_;
    std::vector<std::vector<Range>>   ranges_;   ///< by fillet and facet, rows of a column together
    std::vector<std::vector<Passage>> passages_; ///< alike
  };
} // namespace vfife

#endif
