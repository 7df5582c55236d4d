//! The answer for people.

use crate::command::digits::shown;
use tribos::push::{PathEnd, PushResult};
use tribos::scene::PushScene;

/// A line a result.
pub fn text(scene: &PushScene, answer: &PushResult) -> String {
    let mut text = String::new();
    let mut line = |name: &str, value: String| text += &format!("{name:<16}{value}\n");
    let degrees = |angle: f64| shown(angle.to_degrees());
    let first = &answer.first;
    let [right, left] = answer.cone.angles();
    line(
        "body",
        match scene.mu_across {
            None => format!("{}, {} N, mu {}", scene.patch, scene.load, scene.mu),
            Some(across) => format!(
                "{}, {} N, mu {} along the axis and {across} across it",
                scene.patch, scene.load, scene.mu
            ),
        },
    );
    if let Some(grip) = &answer.grip {
        let holds = if grip.is_stable {
            "yes: the body moves with the pusher"
        } else {
            "no: the pusher cannot give the force that this motion needs"
        };
        line("stable push", holds.into());
        line(
            "needed force",
            format!(
                "{}, {} N and {} N m",
                shown(grip.wrench.force.x),
                shown(grip.wrench.force.y),
                shown(grip.wrench.torque)
            ),
        );
        line(
            "it acts",
            format!(
                "at {} of the way along the pusher (0 to 1), tangent over normal {} (+-{})",
                shown(grip.place),
                shown(grip.friction),
                scene.mu_pusher
            ),
        );
    } else {
        line(
            "motion cone",
            format!(
                "from {} to {} deg off the inward normal, counterclockwise; friction cone +-{} deg",
                degrees(right),
                degrees(left),
                degrees(scene.mu_pusher.atan())
            ),
        );
        line("pusher", first.mode.to_string());
        let speed = first.twist.speed();
        line(
            "body moves",
            format!(
                "{}, {} m/s ({} m/s) and {} rad/s",
                shown(first.twist.velocity.x),
                shown(first.twist.velocity.y),
                shown(speed),
                shown(first.twist.spin)
            ),
        );
        let slip = first.slip.dot(&answer.cone.contact.tangent());
        if slip != 0.0 {
            line(
                "slip",
                format!("{} m/s to the left along the body", shown(slip)),
            );
        }
        line(
            "push",
            format!(
                "{}, {} N and {} N m; gauge {}",
                shown(first.wrench.force.x),
                shown(first.wrench.force.y),
                shown(first.wrench.torque),
                shown(answer.gauge)
            ),
        );
    }
    let mut yaw = format!("{} N m without force", shown(answer.yaw_limit));
    if let Some(limit) = answer.yaw_limit_of_any_pressure {
        yaw += &format!(
            "; at most {} N m under any pressure with this centre",
            shown(limit)
        );
    }
    line("yaw limit", yaw);
    if answer.journey.end == PathEnd::Loose {
        line("path", format!("not followed: {}", answer.journey.end));
    } else if let Some(last) = answer.journey.moments.last() {
        line(
            "path",
            format!(
                "{} after {} s: body at {}, {} m, turned by {} deg",
                answer.journey.end,
                shown(last.time),
                shown(last.pose.x),
                shown(last.pose.y),
                degrees(last.pose.angle)
            ),
        );
        if answer.grip.is_none() {
            line("at the end", last.push.mode.to_string());
        }
    }
    text
}
