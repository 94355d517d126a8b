#include "ui/tile_drawing.h"

#include "ui/plane_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace druse::ui {

namespace {

class TilePicture : private PlanePicture {
public:
    TilePicture(const TileView& view, bool dark, double scale, Image& image)
        : PlanePicture(view, dark, scale, image), view_(view), tile_(view.tile()), outline_(view.tile().outline_points())
    {
        if (outline_.empty()) return;
        middle_ = 0.5 * (tile_.low() + tile_.high());
        for (const Point2& p : outline_) reach_ = std::max(reach_, glm::distance(p, middle_));
    }

    /// Grid, picture and copies.
    void draw_backdrop()
    {
        painter_.clear(colours_.background);
        if (view_.picture() && tile_.look.trace) draw_traced(*tile_.look.trace, *view_.picture());
        if (tile_.type && view_.shown().neighbours)
            for (std::size_t c = tile_.copies.size(); c-- > 1;) draw_copy(c);
        if (view_.shown().grid) draw_grid();
        if (tile_.type && view_.shown().neighbours && has_room_for_handles())
            for (std::size_t c = 1; c < tile_.copies.size(); ++c) draw_small_handles(tile_.copies[c].map);
    }

    void draw_foreground()
    {
        if (!tile_.type) return;
        draw_tile();
        if (view_.shown().arrows) draw_arrows();
        if (view_.shown().centres)
            for (const RotationCentre& c : tile_.centres) draw_centre(c);
        draw_handles();
        if (view_.hovered()) draw_hovered(*view_.hovered());
        if (view_.offset()) draw_ghost(*view_.offset());
        if (view_.refused()) draw_refused();
        draw_gestures();
    }

private:
    std::vector<Point2> placed(const Isometry& map) const
    {
        std::vector<Point2> points(outline_.size());
        for (std::size_t i = 0; i < points.size(); ++i) points[i] = at(map(outline_[i]));
        return points;
    }

    void draw_traced(const TileTrace& trace, const Image& picture)
    {
        const auto& p = trace.place;
        const double det = p[0] * p[4] - p[1] * p[3];
        // Of the plane to the picture's pixels: (u, v) is one wide, from its lower left corner.
        const auto pixel = [&](const Point2& place) {
            const Point2 q = plane_.plane(place) - Point2(p[2], p[5]);
            const Point2 uv = Point2(p[4] * q.x - p[1] * q.y, p[0] * q.y - p[3] * q.x) / det;
            return Point2(uv.x * picture.width, picture.height - uv.y * picture.width);
        };
        const Point2 origin = pixel({0, 0});
        painter_.picture(picture, origin, pixel({1, 0}) - origin, pixel({0, 1}) - origin, trace.opacity);
    }

    /// Without points that are hardly apart: what is left of copies looks the same, and is drawn sooner.
    static std::vector<Point2> thinned(const std::vector<Point2>& points)
    {
        constexpr double apart = 3; // pixels
        std::vector<Point2> kept;
        for (const Point2& p : points)
            if (kept.empty() || glm::distance(kept.back(), p) >= apart) kept.push_back(p);
        return kept;
    }

    /// May a copy be seen? By the circle around the tile.
    bool is_seen(const Isometry& map) const
    {
        const Point2 c = at(map(middle_));
        const double r = reach_ * plane_.pixels + 1;
        return c.x + r >= 0 && c.y + r >= 0 && c.x - r <= plane_.width && c.y - r <= plane_.height;
    }

    Colour copy_colour(int number) const
    {
        const std::size_t k = std::size_t(number) % 3;
        return view_.shown().colours ? tile_.look.colours[k] : colours_.neighbours[k];
    }

    double fill_opacity() const { return view_.picture() ? 0.45 : 1; }

    void draw_copy(std::size_t c)
    {
        if (!is_seen(tile_.copies[c].map)) return;
        const std::vector<Point2> points = thinned(placed(tile_.copies[c].map));
        painter_.fill(points, copy_colour(tile_.copies[c].colour), fill_opacity());
        painter_.lines(points, true, scale_, colours_.neighbour_line);
    }

    void draw_tile()
    {
        const std::vector<Point2> points = placed({});
        painter_.fill(points, view_.shown().colours ? tile_.look.colours[std::size_t(tile_.copies[0].colour) % 3] : colours_.tile, fill_opacity());
        if (view_.shown().triangles)
            for (const auto& t : tile_.triangles)
                for (std::size_t k = 0; k < 3; ++k) {
                    const int a = t[k], b = t[(k + 1) % 3];
                    const bool on_outline = a < tile_.outline && b == (a + 1) % tile_.outline;
                    // Each inner edge has two triangles: drawn once.
                    if (a < b && !on_outline && !(b < tile_.outline && a == (b + 1) % tile_.outline))
                        draw_triangle_edge(tile_.points[std::size_t(a)].at, tile_.points[std::size_t(b)].at, colours_.triangle);
                }
        for (const auto& s : tile_.segments)
            draw_constraint(tile_.points[std::size_t(s[0])].at, tile_.points[std::size_t(s[1])].at, colours_.segment);
        painter_.lines(points, true, 2.2 * scale_, colours_.line);
    }

    /// Handles of copies help only where they do not run together.
    bool has_room_for_handles() const
    {
        double around = 0;
        for (std::size_t i = 0; i < outline_.size(); ++i) around += glm::distance(outline_[i], outline_[(i + 1) % outline_.size()]);
        return around * plane_.pixels > 10 * scale_ * double(outline_.size());
    }

    void draw_small_handles(const Isometry& map)
    {
        if (!is_seen(map)) return;
        for (const Point2& p : outline_) painter_.disc(at(map(p)), 2.2 * scale_, colours_.neighbour_line);
    }

    std::vector<Point2> polygon(const Point2& centre, int sides, double radius, double turn) const
    {
        std::vector<Point2> points;
        for (int i = 0; i < sides; ++i) {
            const double a = turn + 2 * std::numbers::pi * i / sides;
            points.push_back(centre + radius * Point2(std::cos(a), std::sin(a)));
        }
        return points;
    }

    /// ▲ ■ ⬣, and a rhomb where half turns are all.
    void draw_centre(const RotationCentre& centre)
    {
        const Point2 c = at(centre.at);
        const double r = 8 * scale_, up = -std::numbers::pi / 2;
        std::vector<Point2> mark;
        switch (centre.order) {
        case 2: mark = {c + Point2(0, -r), c + Point2(0.5 * r, 0), c + Point2(0, r), c + Point2(-0.5 * r, 0)}; break;
        case 3: mark = polygon(c, 3, r, up); break;
        case 4: mark = polygon(c, 4, r, up / 2); break;
        default: mark = polygon(c, 6, r, 0); break;
        }
        painter_.lines(mark, true, 4 * scale_, colours_.handle_line);
        painter_.lines(mark, true, 2 * scale_, colours_.centre);
    }

    void draw_arrow(const Point2& from, const Point2& to)
    {
        const double length = glm::distance(from, to), head = 9 * scale_;
        if (length < 2 * head) return;
        const Point2 along = (to - from) / length, across(-along.y, along.x);
        for (const auto& [width, colour] : {std::pair(4.0, colours_.handle_line), std::pair(1.8, colours_.arrow)}) {
            painter_.line(from, to, width * scale_, colour);
            painter_.line(to, to - head * along + 0.5 * head * across, width * scale_, colour);
            painter_.line(to, to - head * along - 0.5 * head * across, width * scale_, colour);
        }
    }

    /// From the middle of the tile to those of the tiles beyond its edges.
    void draw_arrows()
    {
        Point2 middle(0.0);
        for (const Point2& p : outline_) middle += p / double(outline_.size());
        for (const TileNeighbour& beyond : tile_.type->neighbours[0])
            for (const DrawnCopy& copy : tile_.copies)
                if (copy.aspect == beyond.aspect && copy.shift == beyond.shift) {
                    const Point2 from = at(middle), to = at(copy.map(middle));
                    draw_arrow(from + 0.12 * (to - from), to - 0.12 * (to - from));
                }
    }

    bool is_selected(const TilePoint& p) const { return view_.selected().contains(p.name); }

    void draw_handles()
    {
        std::vector<char> orbit_selected(tile_.points.size() + 1, 0);
        for (const TilePoint& p : tile_.points)
            if (p.orbit >= 0 && is_selected(p)) orbit_selected[std::size_t(p.orbit)] = 1;
        const bool room = has_room_for_handles();
        for (const TilePoint& p : tile_.points) {
            const bool here = is_selected(p), together = !here && p.orbit >= 0 && orbit_selected[std::size_t(p.orbit)] != 0;
            if (!room && !here && !together && p.kind != TilePoint::Kind::corner) continue;
            const HandleMark mark = here ? HandleMark::selected : together ? HandleMark::together : HandleMark::none;
            switch (p.kind) {
            case TilePoint::Kind::corner: draw_corner_handle(p.at, mark, colours_.handle); break;
            case TilePoint::Kind::interior: draw_inner_handle(p.at, mark); break;
            case TilePoint::Kind::middle: draw_handle(p.at, 3, mark, colours_.handle); break;
            case TilePoint::Kind::path: draw_handle(p.at, 4, mark, colours_.handle); break;
            }
        }
    }

    void draw_hovered(const TileHit& hit)
    {
        const Isometry& map = hit.copy < tile_.copies.size() ? tile_.copies[hit.copy].map : tile_.copies[0].map;
        if (hit.point >= 0) {
            draw_ring(map(tile_.points[std::size_t(hit.point)].at));
        } else if (hit.edge >= 0) {
            const Point2 a = at(map(tile_.points[std::size_t(hit.edge)].at)), b = at(map(tile_.points[std::size_t((hit.edge + 1) % tile_.outline)].at));
            painter_.line(a, b, 3.5 * scale_, colours_.selected);
        }
    }

    void draw_ghost(const TileOffset& where)
    {
        const Point2& offset = where.at;
        const Colour colour = where.is_allowed ? colours_.ghost : colours_.error;
        std::vector<Point2> points = outline_;
        for (Point2& p : points) p = at(p + offset);
        painter_.fill(points, colour, 0.28);
        painter_.lines(points, true, 2.5 * scale_, colour);
        for (std::size_t i = std::size_t(tile_.outline); i < tile_.points.size(); ++i) painter_.disc(at(tile_.points[i].at + offset), 3 * scale_, colour);
        draw_arrow(at(outline_[0]), at(outline_[0] + offset));
    }

    /// The edges that the point would have where it may not go.
    void draw_refused()
    {
        const auto& [copy, point, wanted] = *view_.refused();
        if (copy >= tile_.copies.size() || std::size_t(point) >= tile_.points.size()) return;
        const Isometry& map = tile_.copies[copy].map;
        const auto red_line = [&](int other) { draw_red_line(map(wanted), map(tile_.points[std::size_t(other)].at)); };
        if (point < tile_.outline) {
            red_line((point + 1) % tile_.outline);
            red_line((point + tile_.outline - 1) % tile_.outline);
        } else {
            for (const auto& s : tile_.segments)
                if (s[0] == point || s[1] == point) red_line(s[0] == point ? s[1] : s[0]);
        }
        draw_red_ring(map(wanted));
    }

    const TileView& view_;
    const ShownTile& tile_;
    std::vector<Point2> outline_; // in the tile's frame
    Point2 middle_{0.0};
    double reach_ = 0; // from there to the farthest of its points
};

} // namespace

void TileDrawing::draw(const TileView& view, bool dark, double scale, Image& image)
{
    if (backdrop_.width != image.width || backdrop_.height != image.height || version_ != view.backdrop() || dark_ != dark) {
        backdrop_ = Image(image.width, image.height);
        TilePicture(view, dark, scale, backdrop_).draw_backdrop();
        version_ = view.backdrop();
        dark_ = dark;
    }
    image.pixels = backdrop_.pixels;
    TilePicture(view, dark, scale, image).draw_foreground();
}

} // namespace druse::ui
